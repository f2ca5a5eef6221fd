use super::smooth::Smooth;
use super::vector::Vector;

/// Is a mesh as it is told: corners and normals by numbers.
#[derive(Clone, Debug)]
pub(super) struct Mesh {
    pub triangles: &'static [[u16; 3]],
    pub corners: Corners,
    pub normals: Normals,
    pub coordinates: &'static [[f64; 2]],
}

/// Is how corners are told.
#[derive(Clone, Debug)]
pub(super) enum Corners {
    Exact(Vec<Vector>),
    /// By 65536ths of the sides of a box.
    Steps {
        low: Vector,
        sides: Vector,
        steps: &'static [[u16; 3]],
    },
}

/// Is how normals are told.
#[derive(Clone, Debug)]
pub(super) enum Normals {
    Flat,
    Exact(Vec<Vector>),
    /// By points of an octahedron, unfolded to a square of 65534 steps.
    Octahedron(&'static [[i16; 2]]),
}

impl Mesh {
    /// Takes the mesh apart.
    pub fn facets(&self) -> Vec<Smooth> {
        self.triangles.iter().map(|triangle| self.facet(triangle.map(usize::from))).collect()
    }

    fn facet(&self, numbers: [usize; 3]) -> Smooth {
        let points = numbers.map(|number| self.point(number));
        let plain = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let coordinates = [0, 1, 2].map(|i| self.coordinates.get(numbers[i]).copied().unwrap_or(plain[i]));
        let mut facet = Smooth { points, normals: [Vector([0.0; 3]); 3], coordinates };
        let flat = facet.flat_normal();
        facet.normals = numbers.map(|number| {
            let normal = self.normal(number).unwrap_or(flat);
            if normal.inner(flat) > 0.0 { normal } else { flat }
        });
        facet
    }

    fn point(&self, number: usize) -> Vector {
        match &self.corners {
            Corners::Exact(points) => points[number],
            Corners::Steps { low, sides, steps } => Vector::by_axis(|axis| {
                low.0[axis] + sides.0[axis] * f64::from(steps[number][axis]) / 65_536.0
            }),
        }
    }

    fn normal(&self, number: usize) -> Option<Vector> {
        match &self.normals {
            Normals::Flat => None,
            Normals::Exact(normals) => Some(normals[number]),
            Normals::Octahedron(points) => {
                let [u, v] = points[number].map(|step| f64::from(step) / 32_767.0);
                let z = 1.0 - u.abs() - v.abs();
                // Below the equator the triangle of the square is mirrored at its edge.
                let below = (-z).max(0.0);
                Some(Vector([u - below.copysign(u), v - below.copysign(v), z]).unit())
            }
        }
    }
}
