//! The bench: what a picture costs on a chip, in instructions, flash, RAM and stack, and how right it is.
//!
//! An image of `examples/measure` is built for each scene and chip and run on the emulated chip. The host
//! checks that the chip drew the very picture whose distance from the reference it tells.

mod account;
mod case;
mod chip;
mod emulator;
mod failure;
mod hierarchies;
mod image;
mod needs;
mod peers;
mod profile;
mod row;
#[path = "../../../examples/boards/sink.rs"]
mod sink;
mod snapshot;
mod table;
mod truth;

pub use account::account;
pub use case::{Case, Choice};
pub use chip::{CHIPS, Chip};
pub(crate) use emulator::{PATIENCE, QEMU, listen};
pub use failure::Failure;
pub use hierarchies::{Cost, cost};
pub(crate) use image::{Image, cargo, project};
pub use profile::{Profile, profile, report};
pub(crate) use profile::{Symbols, plain};
pub use row::Row;
pub use snapshot::{Snapshot, WORST_PSNR};
pub use table::table;

use emulator::Said;
use std::sync::mpsc;
use std::thread;
use truth::Truth;

/// Is the size of the pictures, that of the peers' published figures.
pub const SIZE: [u32; 2] = [320, 240];

/// Names the scenes of the table: those that peers draw, and the lectures'.
pub const SCENES: [&str; 6] =
    ["three-spheres", "tinyraytracer", "c-ray", "playdate", "business-card", "simple"];

/// Names the scenes of which each shows a thing that the others do without: what it costs.
pub const SHOWS: [&str; 16] = [
    "glass",
    "stars",
    "still-life",
    "smooth",
    "textured",
    "bump",
    "displaced",
    "environment",
    "material-table",
    "spots",
    "color-chart",
    "z-buffer",
    "teapot",
    "knot",
    "phantom",
    "isosurface",
];

/// Measures what is chosen; `begin` is told what is at work.
///
/// An image is built while the one before it runs: both take about as long, and each of them one processor.
///
/// # Errors
/// What keeps an image from being built or run, or a picture that is not the host's.
pub fn measure(choice: Choice<'_>, mut begin: impl FnMut(&str)) -> Result<Vec<Row>, Failure> {
    let cases = choice.cases();
    let (sender, images) = mpsc::sync_channel(0);
    thread::scope(|scope| {
        let mut builds =
            cases.iter().map(|Case { scene, chip, mode }| Image::build(chip, scene.name(), mode));
        // Whoever failed no longer listens.
        scope.spawn(move || builds.try_for_each(|image| sender.send(image)));
        let mut truth: Option<Truth> = None;
        let measured = cases.iter().zip(images).map(|(case, image)| {
            let name = case.scene.name();
            let known = truth.take().filter(|truth| truth.scene.name() == name);
            let truth = truth.insert(known.map_or_else(|| Truth::trace(case.scene), Ok)?);
            begin(&format!("{name} on {}, {}", case.chip.name, case.mode));
            measure_case(case, &image?, truth)
        });
        measured.collect()
    })
}

fn measure_case(case: &Case, image: &Image, truth: &Truth) -> Result<Row, Failure> {
    let Case { scene, chip, mode } = case;
    let sizes = image.sizes()?;
    let said = emulator::count_instructions(chip, image, 1)?;
    let judged = truth.judge(chip, mode)?;
    if said.figure(mode, "checksum")? != judged.checksum {
        return Err(Failure::OtherPicture(scene.name().to_owned(), chip.name));
    }
    let mut row = Row::new(chip, scene.name(), mode, sizes, &said, &judged)?;
    // A progressive picture has no rows of its own of which some could stand for all.
    if chip.counts_cycles && *mode != "progressive" {
        add_cycles(chip, image, &said, &mut row)?;
    }
    Ok(row)
}

/// Adds cycles: those that an instruction takes on a slower emulator, in so many rows as it traces in some seconds,
/// but in eight at least.
///
/// Rows differ in their work by far more than in the cycles of an instruction, so that a few say those of the frame.
fn add_cycles(chip: &Chip, image: &Image, said: &Said, row: &mut Row) -> Result<(), Failure> {
    const PATIENCE: u64 = 75_000_000;
    const FEWEST_ROWS: u32 = 8;
    let stride = (said.count(&row.mode)?.div_ceil(PATIENCE) as u32).clamp(1, SIZE[1] / FEWEST_ROWS);
    let cycles = emulator::count_cycles(image, stride)?.count(&row.mode)?;
    let instructions = emulator::count_instructions(chip, image, stride)?.count(&row.mode)?;
    row.set_cycles(cycles as f64 / instructions as f64, stride);
    Ok(())
}
