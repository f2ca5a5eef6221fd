//! What runs on the Pico: one picture, coarse blocks first, then sleep.

#[path = "../../boards/pico/mod.rs"]
#[allow(dead_code, reason = "rows by DMA are for pictures that are drawn row by row")]
mod pico;
#[path = "../../boards/wire.rs"]
#[allow(dead_code, reason = "this firmware sends no rows by DMA")]
mod wire;

use embedded_graphics::{geometry::Size, pixelcolor::Rgb565};
use scanray::{Fixed, Progress, Renderer, Workspace, gallery::fixed};

use self::pico::{DEPTH, SIDE};

#[rp2040_hal::entry]
fn main() -> ! {
    let spare = cortex_m::singleton!(: [[u8; 2]; SIDE] = [[0; 2]; SIDE]).expect("main runs once");
    let (panel, mut lamp, _) = pico::take(spare).expect("a part of the board does not answer");
    let mut display = panel.into_display();
    let view = &fixed::THREE_SPHERES;
    let mut space = Workspace::<Fixed, Rgb565, SIDE, DEPTH>::new();
    let size = Size::new_equal(SIDE as u32);
    let mut renderer = Renderer::new(&view.scene, &view.camera, size, view.settings, &mut space)
        .expect("the renderer refuses the scene");

    // The lamp goes out for a moment after each pass: then the whole panel is equally fine.
    let mut progress = Progress::new(16);
    while !progress.is_complete() {
        let side = progress.side();
        pico::lit(&mut lamp, || {
            while progress.side() == side {
                renderer.refine(&mut progress, &mut display).expect("the panel does not answer");
            }
        });
    }
    pico::sleep()
}
