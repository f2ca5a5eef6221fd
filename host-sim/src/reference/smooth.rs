use super::roots::{Ray, shares};
use super::vector::Vector;

/// Is a triangle with a normal and texture coordinates for each corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Smooth {
    pub points: [Vector; 3],
    pub normals: [Vector; 3],
    pub coordinates: [[f64; 2]; 3],
}

impl Smooth {
    /// Is how much of a normal must look at the viewer, and by what share of the triangle's extent a
    /// point is put off the triangle.
    const MARGIN: f64 = 1.0 / 8192.0;

    /// Answers the unit normal of the flat triangle.
    pub fn flat_normal(&self) -> Vector {
        let [a, b, c] = self.points;
        (b - a).outer(c - a).unit()
    }

    /// Answers the largest difference of a coordinate between the first corner and another.
    fn extent(&self) -> f64 {
        let [a, b, c] = self.points;
        [b - a, c - a].iter().flat_map(|edge| edge.0).map(f64::abs).fold(0.0, f64::max)
    }

    /// Mixes three vectors by the shares of a point.
    fn mix(shares: [f64; 3], vectors: [Vector; 3]) -> Vector {
        let [a, b, c] = vectors;
        a * shares[0] + b * shares[1] + c * shares[2]
    }

    /// Answers where the curved surface is lit that a ray meets at a point of the triangle, and its
    /// unit normal on the viewer's side.
    pub fn lit(&self, ray: &Ray, point: Vector) -> (Vector, Vector) {
        let direction = ray.direction.unit();
        let from_behind = self.flat_normal().inner(direction) > 0.0;
        let turned = |normal: Vector| if from_behind { -normal } else { normal };
        let shares = shares(self.points, point);
        let mut normal = Self::mix(shares, self.normals.map(turned)).unit();
        let away = normal.inner(direction) + Self::MARGIN;
        if away > 0.0 {
            normal = (normal - direction * away).unit();
        }
        // The point as seen on each corner's tangent plane, where that is above it.
        let feet = [0, 1, 2].map(|i| {
            let across = turned(self.normals[i]);
            let foot = point - across * (point - self.points[i]).inner(across);
            if (foot - point).inner(across) > 0.0 { foot } else { point }
        });
        let step = turned(self.flat_normal()) * (Self::MARGIN * self.extent());
        (Self::mix(shares, feet) + step, normal)
    }

    /// Answers the derivatives of the point by the texture coordinates, across a unit normal; 0 where the
    /// coordinates of the corners do not tell two ways apart.
    ///
    /// Over the triangle u and v have gradients; along the derivative by u, v stays and u grows by 1.
    pub fn derivatives(&self, normal: Vector) -> [Vector; 2] {
        let [a, b, c] = self.points;
        let area = (b - a).outer(c - a);
        let gradients = [c - b, a - c, b - a].map(|across| area.outer(across) * (1.0 / area.inner(area)));
        let [of_u, of_v] = [0, 1].map(|axis| Self::mix(self.coordinates.map(|uv| uv[axis]), gradients));
        let along = |grows: Vector, stays: Vector| {
            let way = stays.outer(area);
            let gain = grows.inner(way);
            if gain == 0.0 { Vector::default() } else { way * (1.0 / gain) }
        };
        [along(of_u, of_v), along(of_v, of_u)].map(|way| way - normal * normal.inner(way))
    }

    /// Answers the texture coordinates of a point of the triangle.
    pub fn texture_coordinates(&self, point: Vector) -> [f64; 2] {
        let shares = shares(self.points, point);
        [0, 1].map(|axis| (0..3).map(|corner| shares[corner] * self.coordinates[corner][axis]).sum())
    }
}
