//! The bench: what a picture costs on a chip, in instructions, flash, RAM and stack, and how right it is.
//!
//! An image of `examples/measure` is built for each scene and chip and run on the emulated chip. The host
//! checks that the chip drew the very picture whose distance from the reference it tells.

mod chip;
mod emulator;
mod failure;
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

pub(crate) use emulator::{QEMU, listen};
pub(crate) use image::{Image, cargo, project};
pub(crate) use profile::{Symbols, plain};

pub use chip::{CHIPS, Chip};
pub use failure::Failure;
pub use profile::{Profile, profile, report};
pub use row::Row;
pub use snapshot::{Snapshot, WORST_PSNR};
pub use table::table;

use crate::scenes::{self, Entry};
use emulator::Said;
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

/// Names the ways in which a scene is drawn for the table: all of those for the peers' scenes.
fn modes(scene: &str) -> &'static [&'static str] {
    match scene {
        "three-spheres" => &["exact", "adaptive", "uniform", "jittered", "at-edges", "progressive", "raster"],
        "simple" => &["exact", "adaptive", "raster"],
        "z-buffer" => &["exact", "raster"],
        _ if SHOWS.contains(&scene) => &["exact"],
        _ => &["exact", "adaptive"],
    }
}

/// Chooses what to measure; nothing chosen is everything.
#[derive(Clone, Copy, Debug, Default)]
pub struct Choice<'a> {
    /// The only scene, one of the gallery.
    pub scene: Option<&'a str>,
    /// The only chip.
    pub chip: Option<&'static Chip>,
}

impl Choice<'_> {
    /// Answers the scenes to measure.
    pub fn scenes(&self) -> Vec<Entry> {
        match self.scene {
            Some(name) => scenes::find(name).into_iter().collect(),
            None => SCENES.iter().chain(&SHOWS).filter_map(|name| scenes::find(name)).collect(),
        }
    }

    /// Answers the chips to measure on.
    pub fn chips(&self) -> impl Iterator<Item = &'static Chip> {
        CHIPS.iter().filter(|chip| self.chip.is_none_or(|only| only.name == chip.name))
    }
}

/// Measures what is chosen; `begin` is told what is at work.
///
/// # Errors
/// What keeps an image from being built or run, or a picture that is not the host's.
pub fn measure(choice: Choice<'_>, mut begin: impl FnMut(&str)) -> Result<Vec<Row>, Failure> {
    let mut rows = vec![];
    for scene in choice.scenes() {
        begin(&format!("{}: the reference", scene.name()));
        let truth = Truth::trace(scene)?;
        for chip in choice.chips() {
            for mode in modes(scene.name()) {
                let mut begin =
                    |what: &str| begin(&format!("{} on {}, {mode}: {what}", scene.name(), chip.name));
                rows.push(measure_in(mode, chip, &truth, &mut begin)?);
            }
        }
    }
    Ok(rows)
}

fn measure_in(mode: &str, chip: &Chip, truth: &Truth, begin: &mut dyn FnMut(&str)) -> Result<Row, Failure> {
    let scene = truth.scene.name();
    begin("building");
    let image = Image::build(chip, scene, mode)?;
    let sizes = image.sizes()?;
    begin("counting instructions");
    let said = emulator::count_instructions(chip, &image)?;
    let judged = truth.judge(chip, mode)?;
    if said.figure(mode, "checksum")? != judged.checksum {
        return Err(Failure::OtherPicture(scene.to_owned(), chip.name));
    }
    let mut row = Row::new(chip, scene, mode, sizes, &said, &judged)?;
    // A progressive picture has no rows of its own of which some could stand for all.
    if chip.counts_cycles && mode != "progressive" {
        begin("counting cycles");
        add_cycles(&image, &said, &mut row)?;
    }
    Ok(row)
}

/// Adds cycles, counted on a slower emulator: of so many rows as it traces in some seconds.
fn add_cycles(image: &Image, said: &Said, row: &mut Row) -> Result<(), Failure> {
    const PATIENCE: u64 = 75_000_000;
    let stride = (said.count(&row.mode)?.div_ceil(PATIENCE) as u32).clamp(1, SIZE[1]);
    let said = emulator::count_cycles(image, stride)?;
    row.set_cycles(said.count(&row.mode)?, stride);
    Ok(())
}
