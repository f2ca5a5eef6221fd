use super::RenderError;
use crate::math::Scalar;
use crate::output::{Dither, Transfer};

/// Is how much of a picture is traced: [`Exact`] or [`Adaptive`].
///
/// It is a type, so that firmware carries the code of the quality it draws in and of no other: a choice at
/// run time made every image 12 to 14 KB larger.
pub trait Quality: Copy + Default + sealed::Sealed {
    /// Whether pixels may be filled in.
    const FILLS_IN: bool;
}

/// Traces every pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Exact;

/// Traces every eighth pixel, and more between two that do not see the same objects, tiles, mirror images
/// and lights in about the same colour; the others are filled in.
///
/// In 320x240, at least 99.5 % of each gallery scene's pixels are at most 2 steps of a 5-bit channel
/// from the exact picture, and the others at most 28 steps: tests hold it to that. Objects are not lost
/// where their hull is tight and they are among the first 32 of a row; shadows and mirror images narrower
/// than 8 pixels can be missed in a row, and the next row then looks elsewhere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Adaptive;

impl Quality for Exact {
    const FILLS_IN: bool = false;
}

impl Quality for Adaptive {
    const FILLS_IN: bool = true;
}

mod sealed {
    /// Keeps the list of qualities closed.
    pub trait Sealed {}
    impl Sealed for super::Exact {}
    impl Sealed for super::Adaptive {}
}

/// Is how a picture is made of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Settings<S = f32, Q = Exact> {
    /// How many mirrors light may have met on its way, at most the workspace's `DEPTH`.
    pub depth: u8,
    /// Factor on all light before the transfer curve.
    pub exposure: S,
    /// How light becomes levels.
    pub transfer: Transfer,
    /// How levels are rounded.
    pub dither: Dither,
    /// How much of the picture is traced.
    pub quality: Q,
}

impl<S: Scalar> Settings<S> {
    /// Makes the settings of a usual picture: one bounce, the sRGB curve, ordered dithering, every
    /// pixel traced.
    pub const fn new() -> Self {
        Self { depth: 1, exposure: S::ONE, transfer: Transfer::Srgb, dither: Dither::Ordered, quality: Exact }
    }
}

impl<S: Scalar, Q: Quality> Settings<S, Q> {
    /// Sets the number of mirrors.
    pub const fn with_depth(mut self, depth: u8) -> Self {
        self.depth = depth;
        self
    }

    /// Sets the factor on all light.
    pub const fn with_exposure(mut self, exposure: S) -> Self {
        self.exposure = exposure;
        self
    }

    /// Sets the transfer curve.
    pub const fn with_transfer(mut self, transfer: Transfer) -> Self {
        self.transfer = transfer;
        self
    }

    /// Sets how much of the picture is traced.
    pub const fn with_quality<R: Quality>(self, quality: R) -> Settings<S, R> {
        let Self { depth, exposure, transfer, dither, .. } = self;
        Settings { depth, exposure, transfer, dither, quality }
    }

    /// Accepts an exposure that light can be multiplied by.
    pub(crate) fn check_exposure(&self) -> Result<(), RenderError> {
        let usable = self.exposure >= S::ZERO && self.exposure.in_range();
        if usable { Ok(()) } else { Err(RenderError::Exposure) }
    }

    /// Sets the rounding.
    pub const fn with_dither(mut self, dither: Dither) -> Self {
        self.dither = dither;
        self
    }
}

impl<S: Scalar> Default for Settings<S> {
    fn default() -> Self {
        Self::new()
    }
}
