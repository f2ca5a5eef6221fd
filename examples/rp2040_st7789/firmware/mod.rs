//! What runs on the Pico: one frame, then sleep.

mod board;
#[path = "../../boards/watched.rs"]
mod watched;

use core::panic::PanicInfo;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use embedded_hal::digital::OutputPin;
use scanray::{Fixed, Renderer, Workspace, gallery::fixed};

use self::{
    board::Lamp,
    watched::{Stopwatch, Watched},
};

/// Counts the bytes that go to the bus in one piece: a whole row of two bytes a pixel, so that a row is one transfer.
const BATCH: usize = 2 * board::SIDE as usize;

/// Counts the bounces a ray may take.
const DEPTH: usize = 5;

/// Shows both times to an oscilloscope on the lamp's pin; the emulated board counts the same two spans.
/// A pin that cannot be driven would cost the lamp, not the picture.
impl Stopwatch for Lamp {
    fn rendering(&mut self) {
        let _ = self.set_high();
    }

    fn sending(&mut self) {
        let _ = self.set_low();
    }
}

#[rp2040_hal::entry]
fn main() -> ! {
    let mut batch = [0; BATCH];
    let mut space = Workspace::<Fixed, Rgb565, { board::SIDE as usize }, DEPTH>::new();
    let (mut panel, mut lamp) = board::take(&mut batch).expect("a part of the board does not answer");
    let view = &fixed::SIMPLE;
    let mut target = Watched::new(&mut panel, &mut lamp);
    Renderer::new(&view.scene, &view.camera, target.bounding_box().size, view.settings, &mut space)
        .expect("the renderer refuses the scene")
        .draw(&mut target)
        .expect("the panel does not answer");
    lamp.sending();
    loop {
        cortex_m::asm::wfi();
    }
}

#[panic_handler]
fn halt(_: &PanicInfo) -> ! {
    loop {}
}
