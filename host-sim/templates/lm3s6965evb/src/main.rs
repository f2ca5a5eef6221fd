//! A ray-traced picture on the OLED of an LM3S6965 evaluation board.
//!
//! `scene.rs` is what it shows, `board.rs` the wires.
#![no_std]
#![no_main]

mod board;
mod registers;
#[allow(dead_code, reason = "a baked scene tells its size too")]
mod scene;
mod ssd0323;

use core::panic::PanicInfo;

use embedded_graphics::{pixelcolor::Gray4, prelude::*};
use scanray::{Fixed, Renderer, Workspace};

use board::{Display, Uart};

/// Counts the mirrors that light may meet on its way, at most; each takes 44 bytes of RAM.
const DEPTH: usize = 5;

#[cortex_m_rt::entry]
fn main() -> ! {
    let drawn = board::take().map_err(|_| Trouble::Panel).and_then(|mut display| draw(&mut display));
    Uart.write(match drawn {
        Ok(()) => b"done\n".as_slice(),
        Err(Trouble::Scene) => b"failed: the renderer refuses the scene\n",
        Err(Trouble::Panel) => b"failed: the panel refuses an area\n",
    });
    sleep()
}

/// Says why there is no picture.
enum Trouble {
    Scene,
    Panel,
}

/// Traces the picture row by row; each goes to the panel as soon as it is there.
fn draw(display: &mut Display) -> Result<(), Trouble> {
    let mut workspace = Workspace::<Fixed, Gray4, { board::WIDTH as usize }, DEPTH>::new();
    let size = display.bounding_box().size;
    let renderer = Renderer::new(&scene::SCENE, &scene::CAMERA, size, scene::SETTINGS, &mut workspace);
    renderer.map_err(|_| Trouble::Scene)?.draw(display).map_err(|_| Trouble::Panel)
}

fn sleep() -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}

#[panic_handler]
fn halt(_: &PanicInfo) -> ! {
    Uart.write(b"failed: the firmware panicked\n");
    sleep()
}
