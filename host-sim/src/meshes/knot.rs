use super::bezier::unit;
use crate::bake::Indexed;
use std::f64::consts::TAU;

/// Counts the rings of the tube and the corners of a ring: 10240 triangles.
const RINGS: u16 = 320;
const SIDES: u16 = 16;

/// Is the radius of the tube.
const THICKNESS: f64 = 0.55;

/// Answers a point of the trefoil knot `(sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t)`.
fn curve(t: f64) -> [f64; 3] {
    [t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -(3.0 * t).sin()]
}

/// Answers the way along the curve.
fn tangent(t: f64) -> [f64; 3] {
    let way = [t.cos() + 4.0 * (2.0 * t).cos(), -t.sin() + 4.0 * (2.0 * t).sin(), -3.0 * (3.0 * t).cos()];
    unit(way).unwrap_or([1.0, 0.0, 0.0])
}

/// Makes the tube around a trefoil knot.
///
/// A ring lies across the tangent, turned from the direction of z as far as that is across too: nowhere does
/// the knot run along z.
pub fn knot() -> Indexed {
    let mut mesh = Indexed::default();
    for ring in 0..RINGS {
        let t = TAU * f64::from(ring) / f64::from(RINGS);
        let (center, [x, y, z]) = (curve(t), tangent(t));
        let out = unit([-z * x, -z * y, 1.0 - z * z]).unwrap_or([1.0, 0.0, 0.0]);
        let side = [y * out[2] - z * out[1], z * out[0] - x * out[2], x * out[1] - y * out[0]];
        for corner in 0..SIDES {
            let angle = TAU * f64::from(corner) / f64::from(SIDES);
            let normal: [f64; 3] = std::array::from_fn(|i| out[i] * angle.cos() + side[i] * angle.sin());
            mesh.normals.push(normal);
            mesh.places.push(std::array::from_fn(|i| center[i] + THICKNESS * normal[i]));
        }
    }
    for ring in 0..RINGS {
        for corner in 0..SIDES {
            let at = |ring: u16, corner: u16| ring % RINGS * SIDES + corner % SIDES;
            let square =
                [at(ring, corner), at(ring + 1, corner), at(ring + 1, corner + 1), at(ring, corner + 1)];
            mesh.triangles.push([square[0], square[1], square[2]]);
            mesh.triangles.push([square[0], square[2], square[3]]);
        }
    }
    mesh
}
