//! Corners in 16 bits a coordinate, as [`scanray::Corners::Quantized`] has them.

use super::Bounds;

/// Counts the steps of a side; the last is never reached.
const STEPS: f64 = 65_536.0;

/// Is a box whose sides are cut into 65536 steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// The corner of the lowest coordinates.
    pub low: [f64; 3],
    /// Lengths of the sides.
    pub sides: [f64; 3],
}

impl Steps {
    /// Makes the grid whose first and last step are the sides of a box.
    pub fn over(bounds: &Bounds) -> Self {
        // A box without extent along an axis has one place there, whatever the step.
        Self { low: bounds.low, sides: bounds.sides().map(|side| (side * STEPS / (STEPS - 1.0)).max(1e-3)) }
    }

    /// Answers the steps nearest to a place within the box.
    pub fn steps(&self, place: [f64; 3]) -> [u16; 3] {
        std::array::from_fn(|axis| ((place[axis] - self.low[axis]) / self.sides[axis] * STEPS).round() as u16)
    }

    /// Answers the place of steps.
    pub fn place(&self, steps: [u16; 3]) -> [f64; 3] {
        std::array::from_fn(|axis| self.low[axis] + self.sides[axis] * f64::from(steps[axis]) / STEPS)
    }

    /// Answers how far off a corner is at most, along the axis where it is most.
    pub fn error(&self) -> f64 {
        self.sides.iter().fold(0.0, |most, side| side.max(most)) / STEPS / 2.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_place_comes_back_within_half_a_step(
            (low, sides) in (prop::array::uniform3(-500.0..500.0), prop::array::uniform3(0.0..500.0)),
            shares in prop::array::uniform3(0.0..=1.0),
        ) {
            let high: [f64; 3] = std::array::from_fn(|axis| low[axis] + sides[axis]);
            let grid = Steps::over(&Bounds { low, high });
            let place = std::array::from_fn(|axis| low[axis] + sides[axis] * shares[axis]);
            let back = grid.place(grid.steps(place));
            for axis in 0..3 {
                prop_assert!((back[axis] - place[axis]).abs() <= grid.error() * (1.0 + 1e-9));
            }
        }
    }
}
