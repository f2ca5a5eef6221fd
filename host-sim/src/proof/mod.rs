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

/// Is the most bytes of stack that a picture of one ray a pixel may take beside what the caller holds: the workspace,
/// the row and the renderer; an M0+ that asks cones or smooth triangles for shadows takes the most.
pub const MOST_STACK: u32 = 2048;

/// Is the same of pictures that are filled in, sampled, refined, seen through foreign hierarchies or rasterised;
/// an M0+ that goes along the edges of a surface in voxels takes the most. Adaptive rows keep up to 33
/// samples, 396 bytes.
pub const MOST_STACK_OTHERWISE: u32 = 2944;

/// Names the ways of drawing that trace one ray a pixel, row by row.
const PLAIN: [&str; 3] = ["exact", "panels", "turned"];

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
    /// The pictures that the chip drew.
    pub pictures: Vec<Picture>,
}

impl Proof {
    /// Answers the pictures that take the most stack: of those of one ray a pixel, and of the others.
    pub fn deepest(&self) -> [Option<&Picture>; 2] {
        [true, false].map(|plain| {
            let alike = self.pictures.iter().filter(|picture| picture.is_plain() == plain);
            alike.max_by_key(|picture| picture.stack)
        })
    }

    /// Answers a complaint for each panic that is possible, each picture that is not the host's, and a stack that is
    /// too deep.
    pub fn complaints(&self, sums: &Sums) -> Vec<String> {
        let of = format!("{} in {}", self.chip.name, self.number.name());
        let panics = self.panics.iter().map(|panic| format!("{of} may panic: {panic}"));
        let differences = sums.differences(self.number.name(), &self.pictures);
        let differences = differences.into_iter().map(|difference| format!("{of}: {difference}"));
        let deep =
            self.deepest().into_iter().flatten().filter(|picture| picture.stack > picture.most_stack());
        let deep = deep.map(|picture| {
            let (Picture { scene, way, stack, .. }, most) = (picture, picture.most_stack());
            format!(
                "{of}: {scene}, {way} takes {stack} bytes of stack beside what the caller holds: {most} are allowed"
            )
        });
        panics.chain(differences).chain(deep).collect()
    }
}

impl Picture {
    /// Tells whether it was drawn with one ray a pixel, row by row.
    fn is_plain(&self) -> bool {
        PLAIN.contains(&self.way.as_str())
    }

    /// Answers the bytes of stack that it may take.
    fn most_stack(&self) -> u32 {
        if self.is_plain() { MOST_STACK } else { MOST_STACK_OTHERWISE }
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
    let pictures = emulator::draw(chip, &image)?;
    Ok(Proof { chip, number, code, panics, pictures })
}

/// Answers the panics that are found in an image with planted ones.
///
/// # Errors
/// What keeps the image from being built.
pub fn planted(chip: &Chip, number: Number) -> Result<Vec<Panic>, Failure> {
    panics::panics(&image::build(chip, number, Kind::Planted)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stack_that_is_too_deep_for_its_way_is_named() {
        let picture =
            |way: &str, stack| Picture { scene: "simple".into(), way: way.into(), checksum: 0, stack };
        let too_deep = |pictures| {
            let proof = Proof { chip: &CHIPS[0], number: Number::F32, code: 0, panics: vec![], pictures };
            proof.complaints(&Sums::default()).iter().filter(|text| text.contains("bytes of stack")).count()
        };
        let [most, other] = [MOST_STACK, MOST_STACK_OTHERWISE];
        assert_eq!(too_deep(vec![picture("turned", most), picture("at-edges", other)]), 0);
        assert_eq!(too_deep(vec![picture("turned", most + 1), picture("at-edges", other)]), 1);
        assert_eq!(too_deep(vec![picture("turned", most), picture("at-edges", other + 1)]), 1);
    }
}
