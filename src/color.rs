//! Linear light.

use crate::math::{Fixed, Scalar};
use core::ops::{Add, AddAssign, Mul};

/// Is linear light in the sRGB primaries: 1 is the panel's white before exposure.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb<S = f32> {
    /// Red light.
    pub r: S,
    /// Green light.
    pub g: S,
    /// Blue light.
    pub b: S,
}

impl<S> Rgb<S> {
    /// Makes a colour of its three lights.
    pub const fn new(r: S, g: S, b: S) -> Self {
        Self { r, g, b }
    }
}

impl Rgb<Fixed> {
    /// Rounds three literals, at compile time for a constant.
    pub const fn from_f64(r: f64, g: f64, b: f64) -> Self {
        Self::new(Fixed::new(r), Fixed::new(g), Fixed::new(b))
    }
}

impl<S: Scalar> Rgb<S> {
    /// Is the absence of light.
    pub const BLACK: Self = Self::gray(S::ZERO);
    /// Is the panel's white.
    pub const WHITE: Self = Self::gray(S::ONE);

    /// Makes a grey.
    pub const fn gray(level: S) -> Self {
        Self::new(level, level, level)
    }

    /// Tells whether any of the three lights is not zero.
    pub fn is_lit(self) -> bool {
        self != Self::BLACK
    }

    /// Answers the largest of the three lights.
    pub fn max(self) -> S {
        self.r.max(self.g).max(self.b)
    }

    /// Tells whether every light may stand in a scene: from 0 to 1024, in every number.
    pub fn in_range(self) -> bool {
        let limit = S::from_i32(1024);
        [self.r, self.g, self.b].iter().all(|light| *light >= S::ZERO && *light <= limit)
    }
}

impl<S: Scalar> Add for Rgb<S> {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self::new(self.r + rhs.r, self.g + rhs.g, self.b + rhs.b)
    }
}

impl<S: Scalar> AddAssign for Rgb<S> {
    fn add_assign(&mut self, rhs: Self) {
        *self = *self + rhs;
    }
}

impl<S: Scalar> Mul for Rgb<S> {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        Self::new(self.r * rhs.r, self.g * rhs.g, self.b * rhs.b)
    }
}

impl<S: Scalar> Mul<S> for Rgb<S> {
    type Output = Self;
    fn mul(self, rhs: S) -> Self {
        Self::new(self.r * rhs, self.g * rhs, self.b * rhs)
    }
}
