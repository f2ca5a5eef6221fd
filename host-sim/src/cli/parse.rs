//! Words of a command line that stand for more than themselves.

use crate::bench::{CHIPS, Chip};
use crate::shot::Number;

/// Reads the name of a number that the reference judges.
pub(super) fn judged(text: &str) -> Result<Number, String> {
    let numbers = [Number::F32, Number::Fixed, Number::Exact];
    let number = numbers.into_iter().find(|number| number.name() == text);
    number.ok_or_else(|| "the numbers judged by the reference are f32, fixed and exact".to_owned())
}

/// Reads the name of a chip.
pub(super) fn chip(text: &str) -> Result<&'static Chip, String> {
    let names = CHIPS.each_ref().map(|chip| chip.name);
    Chip::find(text).ok_or_else(|| format!("the chips are {}", names.join(", ")))
}
