//! Where the instructions go: an exact count of every executed address, by stage, shape and function.
//!
//! QEMU logs each instruction of the very image that the bench measures, so that nothing is perturbed; the
//! image's debug information tells which functions an address belongs to, inlined ones and callers included.

mod calls;
mod report;
mod stage;
mod symbols;
mod trace;

pub use report::report;
pub(crate) use stage::plain;
pub(crate) use symbols::Symbols;

use super::emulator;
use super::image::Image;
use super::{Chip, Choice, Failure, SIZE};
use calls::Counts;
use stage::{Shape, Stage};
use std::collections::BTreeMap;

/// Says where a picture's instructions go.
#[derive(Debug)]
pub struct Profile {
    /// What was profiled: scene, chip, number and mode.
    pub of: String,
    /// How many rows of the picture were.
    pub rows: u32,
    /// Pixels of these rows.
    pub pixels: u64,
    /// Instructions by stage.
    pub stages: BTreeMap<Stage, u64>,
    /// Instructions by shape, in whichever stage.
    pub shapes: BTreeMap<Shape, u64>,
    /// Instructions by function of the core, and of the compiler's arithmetic.
    pub functions: BTreeMap<String, u64>,
}

/// Profiles what is chosen; `begin` is told what is at work.
///
/// # Errors
/// What keeps an image from being built or run.
pub fn profile(choice: Choice<'_>, mut begin: impl FnMut(&str)) -> Result<Vec<Profile>, Failure> {
    let mut profiles = vec![];
    for scene in choice.scenes() {
        for chip in choice.chips() {
            for mode in ["exact", "adaptive"] {
                begin(&format!("{} on {}, {mode}: tracing", scene.name(), chip.name));
                profiles.push(profile_in(mode, chip, scene.name())?);
            }
        }
    }
    Ok(profiles)
}

fn profile_in(mode: &str, chip: &Chip, scene: &str) -> Result<Profile, Failure> {
    let image = Image::build(chip, scene, mode)?;
    let file = image.read()?;
    let symbols = Symbols::read(&image.path, &file)?;
    let stride = stride(emulator::count_instructions(chip, &image, 1)?.count(mode)?);
    let counts = trace::trace(chip, &image, &symbols, stride)?;
    let name = format!("{scene} on {} in {}, {mode}", chip.name, chip.number.name());
    Ok(gather(name, &counts, &symbols, stride))
}

/// Answers how many rows to leave out between two, lest the log have more lines than one likes to wait for.
fn stride(instructions: u64) -> u32 {
    const LINES: u64 = 20_000_000;
    /// Ten rows tell enough of a picture.
    const MOST: u32 = SIZE[1] / 10;
    (instructions.div_ceil(LINES) as u32).clamp(1, MOST)
}

/// Sorts counts by what their addresses belong to.
fn gather(of: String, counts: &Counts, symbols: &Symbols<'_>, stride: u32) -> Profile {
    let rows = SIZE[1].div_ceil(stride);
    let pixels = u64::from(rows) * u64::from(SIZE[0]);
    let (mut stages, mut shapes, mut functions) = (BTreeMap::new(), BTreeMap::new(), BTreeMap::new());
    let mut known: BTreeMap<u32, Vec<String>> = BTreeMap::new();
    for (sites, count) in counts.by_sites() {
        for site in &sites {
            known.entry(*site).or_insert_with(|| symbols.frames(*site));
        }
        let frames = sites.iter().filter_map(|site| known.get(site)).flatten();
        let frames: Vec<&str> = frames.map(String::as_str).collect();
        *stages.entry(Stage::of(&frames)).or_default() += count;
        if let Some(shape) = Shape::of(&frames) {
            *shapes.entry(shape).or_default() += count;
        }
        *functions.entry(stage::telling(&frames)).or_default() += count;
    }
    Profile { of, rows, pixels, stages, shapes, functions }
}
