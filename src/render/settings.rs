use super::{Exact, Quality, RenderError};
use crate::math::Scalar;
use crate::output::{Dither, Transfer};

/// Is how a picture is made of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Settings<S = f32, Q = Exact> {
    /// How many mirrors and surfaces of glass light may have met on its way, at most the workspace's `DEPTH`.
    pub depth: u8,
    /// Factor on all light before the transfer curve.
    pub exposure: S,
    /// How light becomes levels.
    pub transfer: Transfer,
    /// How levels are rounded.
    pub dither: Dither,
    /// How many rays the picture takes.
    pub quality: Q,
}

impl<S: Scalar> Settings<S> {
    /// Makes the settings of a usual picture: one bounce, the sRGB curve, ordered dithering, one ray a
    /// pixel.
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

    /// Sets how many rays the picture takes.
    ///
    /// ```
    /// use scanray::{AtEdges, Jittered, Settings, Uniform};
    /// let smooth = Settings::<f32>::new().with_quality(Uniform(2));
    /// let smooth_and_quick = Settings::<f32>::new().with_quality(AtEdges(Jittered(3)));
    /// ```
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
