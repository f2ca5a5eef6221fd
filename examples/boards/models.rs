//! What the pictures of models show.

mod balls2;

use scanray::{
    Fixed,
    gallery::{View, fixed},
};

/// Is 91 balls of the Standard Procedural Databases under a tree of boxes, baked of a scene file:
///
/// ```text
/// cargo sim bake scenes/nff/balls2.nff --number fixed --accel bvh -o examples/boards/balls2.rs
/// ```
static BALLS2: View<Fixed> = View {
    name: "balls2",
    about: "91 balls of the Standard Procedural Databases",
    scene: balls2::SCENE,
    camera: balls2::CAMERA,
    settings: balls2::SETTINGS,
    size: balls2::SIZE,
};

/// Lists the models: several hundred smooth triangles, more than ten thousand, and balls that mirror balls.
pub static VIEWS: [&View<Fixed>; 3] = [&fixed::TEAPOT, &fixed::KNOT, &BALLS2];
