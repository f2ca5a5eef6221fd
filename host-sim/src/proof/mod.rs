//! What is proven of the core as it is linked for a chip: that nothing in it can panic, that every chip draws the
//! bits that the host draws, and how deep the stack grows.
//!
//! An image of `examples/proof` draws the whole gallery in every way there is, and holds nothing else. It is built
//! with checks of every sum and product of integers, so that an overflow that the compiler cannot rule out is a panic
//! in the image, and is found there.

mod chip;
mod emulator;
#[path = "../../../examples/proof/frames.rs"]
mod frames;
mod image;
mod panics;
mod sums;
mod table;
#[path = "../../../examples/proof/turning.rs"]
mod turning;
mod turns;

pub use chip::{CHIPS, Chip};
pub use panics::Panic;
pub use sums::Sums;
pub use table::table;
pub use turns::{Turns, turn};

use crate::bench::Failure;
use crate::shot::Number;
pub use emulator::Picture;
use image::Kind;

/// Is the most bytes of stack that a picture may take beside the workspace; edges sampled by an M0+ take the most.
pub const MOST_STACK: u32 = 5376;

/// Lists the numbers that chips compute in.
pub const NUMBERS: [Number; 2] = [Number::F32, Number::Fixed];

/// Chooses what to prove; nothing chosen is everything.
#[derive(Clone, Copy, Debug, Default)]
pub struct Choice {
    /// The only chip.
    pub chip: Option<&'static Chip>,
    /// The only number, one of [`NUMBERS`].
    pub number: Option<Number>,
}

impl Choice {
    /// Answers what is chosen, one after the other.
    fn each(self) -> impl Iterator<Item = (&'static Chip, Number)> {
        let chips = CHIPS.iter().filter(move |chip| self.chip.is_none_or(|only| only.name == chip.name));
        let numbers =
            move || NUMBERS.into_iter().filter(move |number| self.number.is_none_or(|only| only == *number));
        chips.flat_map(move |chip| numbers().map(move |number| (chip, number)))
    }
}

/// Says what was found of a chip and a number.
#[derive(Debug)]
pub struct Proof {
    /// The chip.
    pub chip: &'static Chip,
    /// The number it computes in.
    pub number: Number,
    /// Bytes of code, constants left out: those are the gallery.
    pub code: u64,
    /// Where a panic may begin.
    pub panics: Vec<Panic>,
    /// Bytes of the workspace.
    pub workspace: u32,
    /// The pictures that the chip drew.
    pub pictures: Vec<Picture>,
}

impl Proof {
    /// Answers the picture that takes the most stack.
    pub fn deepest(&self) -> Option<&Picture> {
        self.pictures.iter().max_by_key(|picture| picture.stack)
    }

    /// Answers a complaint for each panic that is possible, each picture that is not the host's, and a stack that is
    /// too deep.
    pub fn complaints(&self, sums: &Sums) -> Vec<String> {
        let of = format!("{} in {}", self.chip.name, self.number.name());
        let panics = self.panics.iter().map(|panic| format!("{of} may panic: {panic}"));
        let differences = sums.differences(self.number.name(), &self.pictures);
        let differences = differences.into_iter().map(|difference| format!("{of}: {difference}"));
        let deep = self.deepest().filter(|picture| picture.stack > self.workspace + MOST_STACK);
        let deep = deep.map(|Picture { scene, way, stack, .. }| {
            let beside = stack - self.workspace;
            format!("{of}: {scene}, {way} takes {beside} bytes of stack beside the workspace: {MOST_STACK} are allowed")
        });
        panics.chain(differences).chain(deep).collect()
    }
}

/// Proves what is chosen; `begin` is told what is at work.
///
/// # Errors
/// What keeps an image from being built or run.
pub fn prove(choice: Choice, mut begin: impl FnMut(&str)) -> Result<Vec<Proof>, Failure> {
    choice.each().map(|(chip, number)| prove_in(chip, number, &mut begin)).collect()
}

fn prove_in(chip: &'static Chip, number: Number, begin: &mut dyn FnMut(&str)) -> Result<Proof, Failure> {
    let mut begin = |what: &str| begin(&format!("{} in {}: {what}", chip.name, number.name()));
    begin("building");
    let image = image::build(chip, number, Kind::Gallery)?;
    begin("seeking panics");
    let (panics, code) = (panics::panics(&image)?, image::code_bytes(&image)?);
    begin("drawing");
    let (workspace, pictures) = emulator::draw(chip, &image)?;
    Ok(Proof { chip, number, code, panics, workspace, pictures })
}

/// Answers the panics that are found in an image with planted ones.
///
/// # Errors
/// What keeps the image from being built.
pub fn planted(chip: &Chip, number: Number) -> Result<Vec<Panic>, Failure> {
    panics::panics(&image::build(chip, number, Kind::Planted)?)
}
