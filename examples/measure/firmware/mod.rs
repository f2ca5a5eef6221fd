//! What runs on the board: the scene, first against the counter, then for its checksum.

mod account;
mod board;
mod chosen;
#[path = "../../boards/decimal.rs"]
mod decimal;
#[cfg_attr(scanray_baked, path = "baked.rs")]
#[cfg_attr(not(scanray_baked), path = "gallery.rs")]
mod scene;
#[path = "../../boards/sink.rs"]
mod sink;

use core::{hint::black_box, panic::PanicInfo};

use embedded_graphics::{geometry::Size, pixelcolor::Rgb565};
use scanray::{Exact, Progress, RasterRenderer, RasterWorkspace, Renderer, RowError, Workspace};

use self::{
    chosen::{ACCOUNT, HEIGHT, MODE, Mode, Number, PROGRESSIVE, RASTER, WIDTH},
    decimal::Decimal,
    scene::{DEPTH, VIEW},
    sink::Sink,
};

/// Is a row in the bytes a display's bus wants.
type Row = [[u8; 2]; WIDTH as usize];

/// Is the workspace; rows go to a buffer of ours, so the workspace needs no room for one.
type Space = Workspace<Number, Rgb565, 0, DEPTH>;

/// Is the workspace of a picture that becomes finer and finer, which is drawn on a panel.
type PanelSpace = Workspace<Number, Rgb565, { WIDTH as usize }, DEPTH>;

/// Is the z-buffer's row of depths.
type RasterSpace = RasterWorkspace<Number, { WIDTH as usize }>;

/// Renders each `stride`th row; those of a stride that the host asks for stand for the whole picture.
#[cortex_m_rt::entry]
fn main() -> ! {
    let stride = board::argument();
    let measured = if ACCOUNT { account::account() } else { measure(stride) };
    // A host that wants the figures only need not wait for the rest.
    board::print(&[b"measured"]);
    match measured.and_then(|()| identify(stride)) {
        Ok(()) => board::end(true),
        Err(what) => fail(what),
    }
}

fn fail(what: &str) -> ! {
    board::print(&[b"failed: ", what.as_bytes()]);
    board::end(false)
}

/// Renders each `stride`th row and hands its pixels to `take`.
#[inline(never)]
fn render(stride: u32, take: &mut dyn FnMut(&[[u8; 2]])) -> Result<(), &'static str> {
    let size = Size::new(WIDTH, HEIGHT);
    // The mode is a constant: only one of the three is in the image.
    if RASTER {
        let mut space = RasterSpace::new();
        let renderer = RasterRenderer::new(&VIEW.scene, &VIEW.camera, size, VIEW.settings, &mut space);
        let mut renderer = renderer.map_err(|_| "the z-buffer refuses the scene")?;
        return render_rows(stride, |y, row| renderer.render_row(y, row), take);
    }
    if PROGRESSIVE {
        return refine(size, take);
    }
    let mut space = Space::new();
    let settings = VIEW.settings.with_quality(Mode::default());
    let mut renderer = Renderer::new(&VIEW.scene, &VIEW.camera, size, settings, &mut space)
        .map_err(|_| "the renderer refuses the scene")?;
    render_rows(stride, |y, row| renderer.render_row(y, row), take)
}

fn render_rows(
    stride: u32,
    mut render_row: impl FnMut(u32, &mut Row) -> Result<(), RowError>,
    take: &mut dyn FnMut(&[[u8; 2]]),
) -> Result<(), &'static str> {
    let mut row = [[0; 2]; WIDTH as usize];
    for y in (0..HEIGHT).step_by(stride as usize) {
        render_row(y, &mut row).map_err(|_| "the renderer refuses a row")?;
        take(&row);
    }
    Ok(())
}

/// Draws blocks of 16 pixels, then finer ones, all that a panel is sent.
fn refine(size: Size, take: &mut dyn FnMut(&[[u8; 2]])) -> Result<(), &'static str> {
    let mut space = PanelSpace::new();
    let settings = VIEW.settings.with_quality(Exact);
    let mut renderer = Renderer::new(&VIEW.scene, &VIEW.camera, size, settings, &mut space)
        .map_err(|_| "the renderer refuses the scene")?;
    let mut progress = Progress::new(16);
    let mut sink = Sink::new(size, take);
    while let Ok(true) = renderer.refine(&mut progress, &mut sink) {}
    Ok(())
}

/// Prints how many ticks of 40 ns the picture takes and how deep the stack grows.
fn measure(stride: u32) -> Result<(), &'static str> {
    board::paint_stack();
    let start = board::ticks();
    render(stride, &mut |row| {
        black_box(row);
    })?;
    let ticks = board::ticks().wrapping_sub(start);
    let stack = board::stack_used();
    print_figure(b" ticks ", ticks);
    print_figure(b" stack ", stack);
    Ok(())
}

/// Prints the checksum by which the host knows the picture.
fn identify(stride: u32) -> Result<(), &'static str> {
    let mut checksum = FNV_OFFSET;
    render(stride, &mut |row| checksum = row.as_flattened().iter().fold(checksum, fnv))?;
    print_figure(b" checksum ", checksum);
    Ok(())
}

fn print_figure(name: &[u8], figure: u32) {
    board::print(&[MODE.as_bytes(), name, Decimal::new(figure).as_bytes()]);
}

/// Is where the 32-bit FNV-1a checksum begins.
const FNV_OFFSET: u32 = 0x811c_9dc5;

/// Takes another byte into the checksum.
fn fnv(sum: u32, byte: &u8) -> u32 {
    (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193)
}

#[panic_handler]
fn halt(_: &PanicInfo) -> ! {
    fail("the firmware panicked")
}

// SAFETY: the name and signature are those the runtime asks for; the handler never returns.
#[cortex_m_rt::exception(trampoline = false)]
unsafe fn HardFault() -> ! {
    fail("the processor faulted")
}
