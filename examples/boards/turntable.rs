//! What the turning pictures show.

use scanray::{
    Camera, Fixed,
    gallery::{View, fixed},
};

/// Is the scene that is turned.
pub static VIEW: &View<Fixed> = &fixed::THREE_SPHERES;

/// Counts the pictures of a turn.
pub const STEPS: u16 = 72;

/// Answers the cameras of one turn after the other, for good.
pub fn cameras() -> impl Iterator<Item = Camera<Fixed>> {
    (0..u32::from(STEPS)).cycle().map(|step| VIEW.camera.turned(step, STEPS))
}
