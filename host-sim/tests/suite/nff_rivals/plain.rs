//! Scenes from which silhouettes can be read.

use super::Kind;
use host_sim::nff::scene::{Fill, Light, Object, Scene, Shape};

/// Is the number of levels that a channel of an object's colour may have.
pub const DIGITS: u32 = 6;

/// Is the distance between two levels, of 255.
const STEP: u8 = 51;

/// Answers the level of a channel.
pub fn digit(channel: u8) -> u32 {
    (u32::from(channel) + u32::from(STEP) / 2) / u32::from(STEP)
}

/// Is a fill of one colour that light makes neither bright nor dark but by its direction.
fn matt(color: [f64; 3]) -> Fill {
    Fill { color, diffuse: 1.0, specular: 0.0, shine: 1.0, transmittance: 0.0, index: 1.0 }
}

/// Answers the colour of an object by its number: its digits as levels.
fn color(number: u32) -> [f64; 3] {
    let digits = [number / (DIGITS * DIGITS), number / DIGITS % DIGITS, number % DIGITS];
    digits.map(|digit| f64::from(digit) * f64::from(STEP) / 255.0)
}

/// Makes the scene for a kind of picture.
pub fn plain(kind: Kind, scene: &Scene) -> Scene {
    let (mut fills, mut objects, mut within_patches) = (vec![], vec![], false);
    for object in &scene.objects {
        let (shape, is_patch) = match &object.shape {
            Shape::Patch(corners) => (Shape::Polygon(corners.iter().map(|corner| corner.0).collect()), true),
            shape => (shape.clone(), false),
        };
        if !(is_patch && within_patches) {
            let number = fills.len() as u32 + 1;
            fills.push(matt(if kind == Kind::Objects { color(number) } else { [1.0; 3] }));
        }
        within_patches = is_patch;
        objects.push(Object { shape, fill: fills.len() - 1 });
    }
    Scene { background: [0.0; 3], lights: vec![lamp(scene)], fills, objects, ..scene.clone() }
}

/// Answers the one lamp: in the direction of the file's first, fifty times as far as the eye is, where even a lamp
/// that is a ball of radius 1 is out of the way.
fn lamp(scene: &Scene) -> Light {
    let (from, at) = (scene.view.from, scene.view.at);
    let way = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|axis| b[axis] - a[axis]);
    let length = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
    let toward = way(at, scene.lights[0].position);
    let factor = 50.0 * length(way(at, from)) / length(toward);
    Light { position: [0, 1, 2].map(|axis| at[axis] + factor * toward[axis]), color: Some([1.0; 3]) }
}
