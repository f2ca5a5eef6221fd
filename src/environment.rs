//! What lies around the scene.

use crate::color::Rgb;
use crate::math::{Scalar, Vec3};

/// Is what a ray sees that meets nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Sky<S = f32> {
    /// The same light everywhere.
    Solid(Rgb<S>),
    /// Light that changes with the height of the direction: `s = (1 + d.up) / 2` runs from
    /// `nadir` at 0 to `zenith` at 1.
    Gradient {
        /// Unit vector toward the zenith.
        up: Vec3<S>,
        /// Light from straight below.
        nadir: Rgb<S>,
        /// Light from straight above.
        zenith: Rgb<S>,
    },
}

impl<S: Scalar> Sky<S> {
    /// Answers the light that arrives from a unit direction.
    pub fn color(&self, direction: Vec3<S>) -> Rgb<S> {
        match *self {
            Self::Solid(color) => color,
            Self::Gradient { up, nadir, zenith } => {
                let s = (S::ONE + direction.dot(up)) * S::HALF;
                nadir * (S::ONE - s) + zenith * s
            }
        }
    }
}
