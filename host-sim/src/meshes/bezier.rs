//! Bicubic Bézier patches, and meshes of them (P. Bézier 1968).

use crate::bake::Indexed;

/// Is four rows of four control points.
pub type Patch = [[[f64; 3]; 4]; 4];

/// Answers the four weights of Bernstein's polynomials, and their derivatives.
fn weights(t: f64) -> [[f64; 4]; 2] {
    let s = 1.0 - t;
    let derivatives = [-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t];
    [[s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t], derivatives]
}

fn mix(patch: &Patch, u: [f64; 4], v: [f64; 4]) -> [f64; 3] {
    std::array::from_fn(|axis| {
        let cell = |i: usize, j: usize| u[i] * v[j] * patch[i][j][axis];
        (0..4).flat_map(|i| (0..4).map(move |j| cell(i, j))).sum()
    })
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Scales a vector to unit length; `None` for one of hardly any length.
pub fn unit(v: [f64; 3]) -> Option<[f64; 3]> {
    let length = v.iter().map(|value| value * value).sum::<f64>().sqrt();
    (length > 1e-9).then(|| v.map(|value| value / length))
}

/// Answers the point of a patch at u and v, and the unit normal there.
///
/// Where one side of a patch is a point the derivative along it is 0: there the normal is that just beside it.
fn point(patch: &Patch, u: f64, v: f64) -> ([f64; 3], [f64; 3]) {
    let normal = |u: f64, v: f64| {
        let ([along, by_u], [across, by_v]) = (weights(u), weights(v));
        unit(cross(mix(patch, by_u, across), mix(patch, along, by_v)))
    };
    let inward = |t: f64| t + 1e-4 * (0.5 - t);
    let normal = normal(u, v).or_else(|| normal(inward(u), inward(v))).unwrap_or([0.0, 0.0, 1.0]);
    (mix(patch, weights(u)[0], weights(v)[0]), normal)
}

/// Makes a mesh of patches, each cut into `cuts` x `cuts` squares of two triangles.
///
/// Corners of the same place and nearly the same normal are one; triangles without area are left out.
pub fn tessellate(patches: &[Patch], cuts: u16) -> Indexed {
    let mut mesh = Indexed::default();
    for patch in patches {
        let share = |i: u16| f64::from(i) / f64::from(cuts);
        let mut corner = |i: u16, j: u16| {
            let (place, normal) = point(patch, share(i), share(j));
            corner_of(&mut mesh, place, normal)
        };
        let corners: Vec<Vec<u16>> = (0..=cuts).map(|i| (0..=cuts).map(|j| corner(i, j)).collect()).collect();
        for (above, below) in corners.iter().zip(&corners[1..]) {
            for (left, right) in (0..usize::from(cuts)).map(|j| (j, j + 1)) {
                let square = [above[left], below[left], below[right], above[right]];
                for triangle in [[square[0], square[1], square[2]], [square[0], square[2], square[3]]] {
                    add_triangle(&mut mesh, triangle);
                }
            }
        }
    }
    mesh
}

/// Answers the number of a corner, a new one where there is none like it.
fn corner_of(mesh: &mut Indexed, place: [f64; 3], normal: [f64; 3]) -> u16 {
    let near = |a: &[f64; 3], b: &[f64; 3], reach: f64| (0..3).all(|axis| (a[axis] - b[axis]).abs() < reach);
    let known = mesh.places.iter().zip(&mesh.normals);
    let found = known.into_iter().position(|(p, n)| near(p, &place, 1e-9) && near(n, &normal, 0.05));
    found.unwrap_or_else(|| {
        mesh.places.push(place);
        mesh.normals.push(normal);
        mesh.places.len() - 1
    }) as u16
}

fn add_triangle(mesh: &mut Indexed, triangle: [u16; 3]) {
    let [a, b, c] = triangle.map(|corner| mesh.places[usize::from(corner)]);
    let edge = |to: [f64; 3]| std::array::from_fn(|axis| to[axis] - a[axis]);
    if unit(cross(edge(b), edge(c))).is_some() {
        mesh.triangles.push(triangle);
    }
}
