//! A ray-traced picture on an ESP32-C3 with an ST7789 panel.
//!
//! `scene.rs` is what it shows, `board.rs` the wires.
#![no_std]
#![no_main]

mod board;
#[allow(dead_code, reason = "a baked scene tells its size too")]
mod scene;

use core::panic::PanicInfo;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use esp_println::println;
use scanray::{Fixed, RenderError, Renderer, Workspace};

use board::{Display, NoAnswer};

/// Counts the mirrors that light may meet on its way, at most; each takes 44 bytes of RAM.
const DEPTH: usize = 5;

// The loader of the ESP32-C3 asks every program for its name and version.
esp_bootloader_esp_idf::esp_app_desc!();

#[esp_hal::main]
fn main() -> ! {
    let mut bytes = [0; board::BUFFER];
    let drawn = board::take(&mut bytes).map_err(Trouble::from).and_then(|mut display| draw(&mut display));
    match drawn {
        Ok(()) => println!("done"),
        Err(Trouble::Scene(error)) => println!("the renderer refuses the scene: {error}"),
        Err(Trouble::Panel) => println!("the panel does not answer"),
    }
    sleep()
}

/// Says why there is no picture.
enum Trouble {
    Scene(RenderError),
    Panel,
}

impl From<NoAnswer> for Trouble {
    fn from(_: NoAnswer) -> Self {
        Self::Panel
    }
}

/// Traces the picture row by row; each goes to the panel as soon as it is there.
fn draw(display: &mut Display) -> Result<(), Trouble> {
    let mut workspace = Workspace::<Fixed, Rgb565, { board::WIDTH as usize }, DEPTH>::new();
    let size = display.bounding_box().size;
    let renderer = Renderer::new(&scene::SCENE, &scene::CAMERA, size, scene::SETTINGS, &mut workspace);
    renderer.map_err(Trouble::Scene)?.draw(display).map_err(|_| Trouble::Panel)
}

fn sleep() -> ! {
    loop {
        core::hint::spin_loop();
    }
}

#[panic_handler]
fn halt(info: &PanicInfo) -> ! {
    println!("{info}");
    sleep()
}
