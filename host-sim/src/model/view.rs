//! Camera and light that show a model: to begin with, to be changed.

use super::place::REACH;
use super::vector::{cross, dot, sub, unit};
use crate::bake::Bounds;
use crate::bake::source::Literal;
use crate::scene_file::value::point;
use scanray::{Camera, Light, Rgb, Sky, Vec3};

/// Is the direction from the model to the camera: in front, on the right, above.
const TOWARD_EYE: [f64; 3] = [0.55, 0.45, 1.0];

/// Is the direction from the model to its key light: on the left, high, a little in front.
const TOWARD_LIGHT: [f64; 3] = [-0.6, 1.0, 0.75];

/// Is the angle between lower and upper edge, in degrees: that of a portrait lens.
const FOVY: f64 = 32.0;

/// Is the columns and rows of the picture.
pub const SIZE: [u32; 2] = [320, 240];

/// Answers the camera that a box just fills the picture of.
pub fn camera<S: Literal>(bounds: &Bounds) -> Camera<S> {
    let middle: [f64; 3] = std::array::from_fn(|axis| bounds.middle(axis));
    let back = unit(TOWARD_EYE).unwrap_or_default();
    let right = unit(cross([0.0, 1.0, 0.0], back)).unwrap_or_default();
    let up = cross(back, right);
    let tangent = (0.5 * FOVY).to_radians().tan();
    let aspect = f64::from(SIZE[0]) / f64::from(SIZE[1]);
    // The eye stands where each corner of the box is inside the window, with a border of a twelfth.
    let needed = (0..8).map(|corner: usize| {
        let place = std::array::from_fn(|axis| [bounds.low, bounds.high][corner >> axis & 1][axis]);
        let offset = sub(place, middle);
        let across = (dot(offset, right) / aspect).abs().max(dot(offset, up).abs());
        dot(offset, back) + across * (13.0 / 12.0) / tangent
    });
    let radius = dot(bounds.sides(), bounds.sides()).sqrt() / 2.0;
    let distance = needed.fold(0.0, f64::max).min(REACH * radius);
    let eye = std::array::from_fn(|axis| middle[axis] + distance * back[axis]);
    Camera::perspective(point(eye), point(middle), point([0.0, 1.0, 0.0]), S::round(FOVY))
}

/// Answers the key light.
pub fn light<S: Literal>() -> Light<S> {
    Light::directional(point(TOWARD_LIGHT), gray(0.95))
}

/// Answers the light from everywhere.
pub fn ambient<S: Literal>() -> Rgb<S> {
    gray(0.25)
}

/// Answers the sky.
pub fn sky<S: Literal>() -> Sky<S> {
    let color = |light: [f64; 3]| {
        let Vec3 { x, y, z } = point(light);
        Rgb::new(x, y, z)
    };
    Sky::Gradient {
        up: point([0.0, 1.0, 0.0]),
        nadir: color([0.75, 0.78, 0.8]),
        zenith: color([0.2, 0.3, 0.5]),
    }
}

/// Answers a grey.
pub fn gray<S: Literal>(level: f64) -> Rgb<S> {
    Rgb::gray(S::round(level))
}
