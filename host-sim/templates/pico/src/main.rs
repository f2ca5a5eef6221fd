//! A ray-traced picture on a Raspberry Pi Pico with an ST7789 panel.
//!
//! `scene.rs` is what it shows, `board.rs` the wires.
#![no_std]
#![no_main]

mod board;
#[allow(dead_code, reason = "a baked scene tells its size too")]
mod scene;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use panic_halt as _;
use scanray::{Fixed, Renderer, Workspace};

use board::{Display, Trouble};

/// Counts the mirrors that light may meet on its way, at most; each takes 44 bytes of RAM.
const DEPTH: usize = 5;

#[rp2040_hal::entry]
fn main() -> ! {
    let (mut lamp, display) = board::take();
    lamp.on();
    let drawn = display.and_then(|mut display| draw(&mut display));
    lamp.tell(drawn)
}

/// Traces the picture row by row; each goes to the panel as soon as it is there.
fn draw(display: &mut Display) -> Result<(), Trouble> {
    let mut workspace = Workspace::<Fixed, Rgb565, { board::WIDTH as usize }, DEPTH>::new();
    let size = display.bounding_box().size;
    let renderer = Renderer::new(&scene::SCENE, &scene::CAMERA, size, scene::SETTINGS, &mut workspace);
    renderer.map_err(|_| Trouble::Scene)?.draw(display).map_err(|_| Trouble::Panel)
}
