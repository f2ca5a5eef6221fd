//! A camera that turns for long: the pictures of every turn are those of the first, and the host's.

use super::image::{self, Kind};
use super::{Chip, Choice, emulator, turning};
use crate::bench::{Failure, PATIENCE};
use crate::shot::Number;
use scanray::Fixed;
use scanray::gallery::Gallery;
use std::fmt;

/// Says what a chip drew, turn by turn.
#[derive(Debug)]
pub struct Turns {
    /// The chip.
    pub chip: &'static Chip,
    /// The number it computes in.
    pub number: Number,
    /// The checksum of the host's turn.
    host: Option<u32>,
    /// The checksums of the chip's turns.
    drawn: Vec<u32>,
}

impl Turns {
    /// Answers the first turn that is not the host's.
    pub fn astray(&self) -> Option<usize> {
        self.drawn.iter().position(|checksum| Some(*checksum) != self.host)
    }
}

impl fmt::Display for Turns {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (turns, pictures) = (self.drawn.len(), self.drawn.len() * usize::from(turning::STEPS));
        write!(f, "{} in {}: {turns} turns, {pictures} pictures: ", self.chip.name, self.number.name())?;
        match self.astray() {
            None => write!(f, "each turn is the host's, {:08x}", self.host.unwrap_or_default()),
            Some(turn) => write!(f, "turn {} is not the host's", turn + 1),
        }
    }
}

/// Lets the chosen chips draw so many turns; `begin` is told what is at work.
///
/// # Errors
/// What keeps an image from being built or run, and a chip that draws fewer turns.
pub fn turn(choice: Choice, turns: u32, mut begin: impl FnMut(&str)) -> Result<Vec<Turns>, Failure> {
    let of_chip = |(chip, number): (&'static Chip, Number)| {
        begin(&format!("{} in {}: {turns} turns", chip.name, number.name()));
        let image = image::build(chip, number, Kind::Turning(turns))?;
        let said = emulator::run(chip, &image, PATIENCE * turns)?;
        let host = if number == Number::F32 { host::<f32>() } else { host::<Fixed>() };
        match understand(&said) {
            Some(drawn) if drawn.len() == turns as usize => Ok(Turns { chip, number, host, drawn }),
            _ => Err(Failure::Firmware(said)),
        }
    };
    choice.each().map(of_chip).collect()
}

/// Draws a turn on the host.
fn host<S: Gallery>() -> Option<u32> {
    turning::turn(S::find(turning::SCENE)?, &mut turning::Space::<S>::new(), 0)
}

/// Reads `turn CHECKSUM` from every line.
fn understand(said: &str) -> Option<Vec<u32>> {
    said.lines().map(|line| line.strip_prefix("turn ")?.parse().ok()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turns(drawn: Vec<u32>) -> Turns {
        Turns { chip: &super::super::CHIPS[0], number: Number::Fixed, host: Some(7), drawn }
    }

    #[test]
    fn a_turn_that_goes_astray_is_counted_from_one() {
        assert_eq!(
            turns(vec![7, 7]).to_string(),
            "m0+ in fixed: 2 turns, 144 pictures: each turn is the host's, 00000007"
        );
        assert_eq!(
            turns(vec![7, 8, 7]).to_string(),
            "m0+ in fixed: 3 turns, 216 pictures: turn 2 is not the host's"
        );
        assert_eq!(turns(vec![7, 8, 7]).astray(), Some(1));
    }

    #[test]
    fn a_chip_that_says_anything_else_has_drawn_nothing() {
        assert_eq!(understand("turn 7\nturn 4294967295\n"), Some(vec![7, u32::MAX]));
        assert_eq!(understand("turn 7\nfailed: the processor faulted\n"), None);
    }
}
