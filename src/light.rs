//! Sources of light.

use crate::color::Rgb;
use crate::math::{Scalar, Vec3};

/// Is a source of light without extent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Light<S = f32> {
    /// Shines from a point in all directions, the same at any distance (row L6).
    Point {
        /// Where it is.
        position: Vec3<S>,
        /// How much light arrives.
        color: Rgb<S>,
    },
    /// Shines from infinitely far away (row L6).
    Directional {
        /// Where the light comes from, of any length but zero.
        toward: Vec3<S>,
        /// How much light arrives.
        color: Rgb<S>,
    },
}

impl<S: Scalar> Light<S> {
    /// Makes a light at a point.
    pub const fn point(position: Vec3<S>, color: Rgb<S>) -> Self {
        Self::Point { position, color }
    }

    /// Makes a light that comes from a direction of any length.
    pub const fn directional(toward: Vec3<S>, color: Rgb<S>) -> Self {
        Self::Directional { toward, color }
    }

    /// Answers how much light arrives.
    pub fn color(&self) -> Rgb<S> {
        match *self {
            Self::Point { color, .. } | Self::Directional { color, .. } => color,
        }
    }
}
