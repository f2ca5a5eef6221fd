//! Scenes as J. Stone's Tachyon reads them from files of the format, with what it leaves out told otherwise.
//!
//! It takes each angle for that of a window one high at the distance 1, turns left and right round, sends its rays
//! through the far corners of pixels, gives every fill an ambient share of a tenth, and has no cones: they are prisms
//! here.

use super::{Kind, Pixels, run};
use crate::nff_text;
use host_sim::nff::scene::{Fill, Object, Scene, Shape};
use scanray::{Camera, Projection, Vec3};
use std::f64::consts::TAU;

/// Is what it shows of white without light: a tenth, of 255.
pub const AMBIENT: u8 = 26;

/// Is the number of a prism's sides: it is within a thousandth of the cone's radius.
const SIDES: u32 = 96;

/// Draws a scene.
pub fn draw(kind: Kind, scene: &Scene) -> Pixels {
    let mut scene = scene.clone();
    if kind == Kind::Objects {
        // The ambient share alone, and ten times as much of it.
        let shown = |fill: &Fill| Fill { color: fill.color.map(|c| 10.0 * c), diffuse: 0.0, ..*fill };
        scene.fills = scene.fills.iter().map(shown).collect();
    }
    scene.objects = scene.objects.iter().flat_map(prism).collect();
    let text = nff_text::write(&scene);
    run("tachyon", &["x.nff", "-o", "x.png", "-format", "PNG", "-fullshade"], ["x.nff", &text])
}

/// Answers a camera that sends its rays where Tachyon sends them, of the same eye.
pub fn camera(camera: Camera<f64>) -> Camera<f64> {
    // The window is on the near plane; what stands before it is farther away than this in every file.
    let near = (camera.center - camera.eye).length() / 256.0;
    let [half, corner] = [0.5 * near, 0.5 * near / 512.0];
    let window = Projection::Frustum {
        left: half - corner,
        right: -half - corner,
        bottom: corner - half,
        top: half + corner,
    };
    Camera { projection: window, near, ..camera }
}

/// Puts a prism in the place of a cone that is no cylinder.
fn prism(object: &Object) -> Vec<Object> {
    let Shape::Cone { ends, radii: [p, q] } = &object.shape else { return vec![object.clone()] };
    if p == q {
        return vec![object.clone()];
    }
    let ends = ends.map(Vec3::from_array);
    let unit = |v: Vec3<f64>| v * (1.0 / v.length());
    let axis = unit(ends[1] - ends[0]);
    let least = if axis.x.abs() < 0.7 { Vec3::new(1.0, 0.0, 0.0) } else { Vec3::new(0.0, 1.0, 0.0) };
    let side = unit(axis.cross(least));
    let rim = |end: usize, number: u32| {
        let (sine, cosine) = (TAU * f64::from(number) / f64::from(SIDES)).sin_cos();
        (ends[end] + (side * cosine + axis.cross(side) * sine) * [*p, *q][end]).to_array()
    };
    let face = |n| Shape::Polygon(vec![rim(0, n), rim(0, n + 1), rim(1, n + 1), rim(1, n)]);
    (0..SIDES).map(|n| Object { shape: face(n), fill: object.fill }).collect()
}
