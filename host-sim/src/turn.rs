//! Turns: how far a camera is carried around what it looks at.

use scanray::{Camera, Scalar};
use std::str::FromStr;

/// Is so many of the equal steps of a whole turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Turn {
    step: u32,
    steps: u16,
}

impl Turn {
    /// Leaves the camera where it is.
    pub const NONE: Self = Self { step: 0, steps: 1 };

    /// Makes the beginning of a turn of so many steps.
    pub fn of(steps: u16) -> Self {
        Self { step: 0, steps }
    }

    /// Answers the turn one step on; the step after the last is the first.
    pub fn next(self) -> Self {
        Self { step: (self.step + 1) % u32::from(self.steps.max(1)), ..self }
    }

    /// Carries a camera around its center, in the camera's own number: firmware gets the same bits.
    pub fn carry<S: Scalar>(self, camera: &Camera<S>) -> Camera<S> {
        camera.turned(self.step, self.steps)
    }
}

impl FromStr for Turn {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/').and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
        match parts {
            Some((step, steps)) if steps > 0 => Ok(Self { step, steps }),
            _ => Err(format!("a step is one of at most {} of a turn, written such as 3/72", u16::MAX)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_step_after_the_last_is_the_first() {
        let turns: Vec<Turn> =
            std::iter::successors(Some(Turn::of(3)), |turn| Some(turn.next())).take(4).collect();
        assert_eq!(turns.iter().map(|turn| turn.step).collect::<Vec<_>>(), [0, 1, 2, 0]);
        assert_eq!(Turn::NONE.next(), Turn::NONE);
    }

    #[test]
    fn a_turn_is_written_as_a_step_of_steps() {
        assert_eq!("3/72".parse(), Ok(Turn { step: 3, steps: 72 }));
        for wrong in ["", "3", "3/", "/72", "3/0", "-1/4", "1/65536", "1/2/3", "0.5/2"] {
            assert!(wrong.parse::<Turn>().is_err(), "{wrong:?}");
        }
    }
}
