//! A camera that turns for good around a scene, on a chip and on the host alike.

use embedded_graphics::prelude::Size;
use scanray::gallery::View;
use scanray::{Renderer, Scalar, Workspace};

/// Names the scene of the gallery that is turned, as in `rp2040_spin`.
pub const SCENE: &str = "three-spheres";

/// Counts the pictures of a turn.
pub const STEPS: u16 = 72;

/// Counts the pixels of a row, and the rows of a picture.
const SIDE: usize = 240;

/// Is what all pictures are drawn in, one after the other: what one leaves behind must not show in the next.
pub type Space<S> = Workspace<S, [u8; 2], 0, 5>;

/// Draws the turn of a number and answers the 32-bit FNV-1a checksum of all its pictures; `None` where the core refuses
/// one. Steps are counted on from turn to turn, as firmware does.
pub fn turn<S: Scalar>(view: &View<S>, space: &mut Space<S>, number: u32) -> Option<u32> {
    let size = Size::new(SIDE as u32, SIDE as u32);
    let first = number.wrapping_mul(u32::from(STEPS));
    let mut sum = 0x811c_9dc5_u32;
    for step in 0..u32::from(STEPS) {
        let camera = view.camera.turned(first.wrapping_add(step), STEPS);
        let mut renderer = Renderer::new(&view.scene, &camera, size, view.settings, space).ok()?;
        let mut row = [[0; 2]; SIDE];
        for y in 0..size.height {
            renderer.render_row(y, &mut row).ok()?;
            for byte in row.as_flattened() {
                sum = (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193);
            }
        }
    }
    Some(sum)
}
