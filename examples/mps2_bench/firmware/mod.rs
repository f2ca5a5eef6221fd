//! What runs on the board: each scene twice, once against the counter and once into a file.

mod board;
#[path = "../../boards/decimal.rs"]
mod decimal;

use core::{ffi::CStr, hint::black_box, panic::PanicInfo};

use embedded_graphics::{geometry::Size, pixelcolor::Rgb565};
use scanray::{
    Renderer, Workspace,
    gallery::{View, float},
};

use self::{board::File, decimal::Decimal};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 240;
const DEPTH: usize = 5;

/// Is a row in the bytes a display's bus wants.
type Row = [[u8; 2]; WIDTH as usize];

/// Is the workspace; rows go to a buffer of ours, so the workspace needs no room for one.
type Space = Workspace<f32, Rgb565, 0, DEPTH>;

/// Lists the scenes, and the files their pictures go to.
static SCENES: [(&View<f32>, &CStr); 2] =
    [(&float::THREE_SPHERES, c"three-spheres.rgb565"), (&float::SIMPLE, c"simple.rgb565")];

#[cortex_m_rt::entry]
fn main() -> ! {
    match SCENES.iter().try_for_each(|(view, file)| measure(view).and_then(|()| keep(view, file))) {
        Ok(()) => board::print(&[b"done"]),
        Err(what) => board::print(&[b"failed: ", what.as_bytes()]),
    }
    sleep()
}

fn sleep() -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}

/// Renders each row of `view` and hands it to `use_row`.
fn render(view: &View<f32>, mut use_row: impl FnMut(&Row) -> bool) -> Result<(), &'static str> {
    let mut space = Space::new();
    let size = Size::new(WIDTH, HEIGHT);
    let mut renderer = Renderer::new(&view.scene, &view.camera, size, view.settings, &mut space)
        .map_err(|_| "the renderer refuses the scene")?;
    let mut row = [[0; 2]; WIDTH as usize];
    for y in 0..HEIGHT {
        renderer.render_row(y, &mut row).map_err(|_| "the renderer refuses a row")?;
        if !use_row(&row) {
            return Err("the host did not take a row");
        }
    }
    Ok(())
}

/// Prints how many ticks of 40 ns the picture takes.
#[inline(never)]
fn measure(view: &View<f32>) -> Result<(), &'static str> {
    let start = board::ticks();
    render(view, |row| {
        black_box(row);
        true
    })?;
    let ticks = board::ticks().wrapping_sub(start);
    print_figure(view, b" ticks ", ticks);
    Ok(())
}

/// Writes the picture to `file` and prints its checksum.
#[inline(never)]
fn keep(view: &View<f32>, file: &CStr) -> Result<(), &'static str> {
    let mut file = File::create(file).ok_or("the host gives no file")?;
    let mut checksum = FNV_OFFSET;
    render(view, |row| {
        checksum = row.as_flattened().iter().fold(checksum, fnv);
        file.write(row.as_flattened())
    })?;
    print_figure(view, b" checksum ", checksum);
    Ok(())
}

fn print_figure(view: &View<f32>, name: &[u8], figure: u32) {
    board::print(&[view.name.as_bytes(), name, Decimal::new(figure).as_bytes()]);
}

/// Is where the 32-bit FNV-1a checksum begins.
const FNV_OFFSET: u32 = 0x811c_9dc5;

/// Takes another byte into the checksum.
fn fnv(sum: u32, byte: &u8) -> u32 {
    (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193)
}

#[panic_handler]
fn halt(_: &PanicInfo) -> ! {
    board::print(&[b"failed: the firmware panicked"]);
    sleep()
}

// SAFETY: the name and signature are those the runtime asks for; the handler never returns.
#[cortex_m_rt::exception(trampoline = false)]
unsafe fn HardFault() -> ! {
    board::print(&[b"failed: the processor faulted"]);
    sleep()
}
