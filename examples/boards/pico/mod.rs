//! A Raspberry Pi Pico with an ST7789 panel of 240x240 pixels on SPI0, fed by DMA.
//!
//! | Pico | panel |
//! |---|---|
//! | GPIO 16 | D/C |
//! | GPIO 17 | CS |
//! | GPIO 18 | SCL (SPI clock) |
//! | GPIO 19 | SDA (SPI data) |
//! | GPIO 20 | backlight |
//! | GPIO 21 | reset |
//!
//! The Pico's own LED (GPIO 25) is lit while the first core traces and dark while it waits for the panel.

mod board;
mod display;
mod panel;

use core::panic::PanicInfo;

use embedded_graphics::geometry::Size;
use embedded_hal::digital::OutputPin;
use scanray::{Camera, Fixed, Renderer, Workspace, gallery::View};

pub use self::{
    board::take,
    panel::{Row, SIDE},
};

/// Counts the bounces a ray may take.
pub const DEPTH: usize = 5;

/// Is what tracing takes beside the rows' buffers.
pub type Space = Workspace<Fixed, [u8; 2], 0, DEPTH>;

/// Traces rows of a picture, as the bus wants them.
pub struct Tracer<'w>(Renderer<'static, 'w, Fixed, [u8; 2], 0, DEPTH>);

impl<'w> Tracer<'w> {
    /// Makes ready to trace what `camera` sees of the view.
    pub fn new(view: &View<Fixed>, camera: &Camera<Fixed>, space: &'w mut Space) -> Self {
        let size = Size::new_equal(SIDE as u32);
        let renderer = Renderer::new(&view.scene, camera, size, view.settings, space);
        Self(renderer.expect("the renderer refuses the scene"))
    }

    /// Traces row `y`.
    pub fn trace(&mut self, y: u32, row: &mut Row) {
        self.0.render_row(y, row.as_mut_slice()).expect("the panel has more rows than the picture");
    }
}

/// Does some work with the lamp on, which shows the time to an oscilloscope and to the emulated board.
pub fn lit(lamp: &mut impl OutputPin, work: impl FnOnce()) {
    // A pin that cannot be driven would cost the lamp, not the picture.
    let _ = lamp.set_high();
    work();
    let _ = lamp.set_low();
}

/// Sleeps for good.
pub fn sleep() -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}

#[panic_handler]
fn halt(_: &PanicInfo) -> ! {
    loop {}
}
