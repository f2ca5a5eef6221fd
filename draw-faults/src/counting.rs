use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Dimensions;
use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_graphics_core::pixelcolor::raw::RawData;
use embedded_graphics_core::primitives::Rectangle;

use crate::call::pixels;

/// Holds what a display was asked to do, in numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Counts the calls of `draw_iter`, failed ones included, as all counts do.
    pub draw_iter: u64,
    /// Counts the calls of `fill_contiguous`.
    pub fill_contiguous: u64,
    /// Counts the calls of `fill_solid`, those of `clear` among them.
    pub fill_solid: u64,
    /// Counts the pixels that the display asked for, and for a solid fill all those of its area.
    pub pixels: u64,
    /// Counts the bytes that these pixels take on a bus: colours of 8 bits and more whole bytes each, smaller ones
    /// packed, each call anew. Commands and addresses are not among them.
    pub bytes: u64,
}

impl Counts {
    /// Answers the number of all calls.
    pub const fn calls(&self) -> u64 {
        self.draw_iter + self.fill_contiguous + self.fill_solid
    }

    fn add<C: PixelColor>(&mut self, pixels: u64) {
        let bits = C::Raw::BITS_PER_PIXEL as u64;
        let bytes = if bits < 8 { (pixels * bits).div_ceil(8) } else { pixels * bits.div_ceil(8) };
        self.pixels += pixels;
        self.bytes += bytes;
    }
}

/// Counts what a display is asked to do.
#[derive(Clone, Debug)]
pub struct Counting<D> {
    inner: D,
    counts: Counts,
}

impl<D> Counting<D> {
    /// Begins to count at zero.
    pub const fn new(inner: D) -> Self {
        Self {
            inner,
            counts: Counts { draw_iter: 0, fill_contiguous: 0, fill_solid: 0, pixels: 0, bytes: 0 },
        }
    }

    /// Answers what was counted since the beginning or the last [`restart`](Self::restart).
    pub const fn counts(&self) -> Counts {
        self.counts
    }

    /// Begins to count anew, and answers what was counted before.
    pub fn restart(&mut self) -> Counts {
        core::mem::take(&mut self.counts)
    }

    /// Answers the display within.
    pub const fn inner(&self) -> &D {
        &self.inner
    }
}

impl<D: Dimensions> Dimensions for Counting<D> {
    fn bounding_box(&self) -> Rectangle {
        self.inner.bounding_box()
    }
}

impl<D: DrawTarget> DrawTarget for Counting<D> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        self.counts.draw_iter += 1;
        let mut taken = 0;
        let drawn = self.inner.draw_iter(pixels.into_iter().inspect(|_| taken += 1));
        self.counts.add::<D::Color>(taken);
        drawn
    }

    fn fill_contiguous<I: IntoIterator<Item = D::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), D::Error> {
        self.counts.fill_contiguous += 1;
        let mut taken = 0;
        let filled = self.inner.fill_contiguous(area, colors.into_iter().inspect(|_| taken += 1));
        self.counts.add::<D::Color>(taken);
        filled
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), D::Error> {
        self.counts.fill_solid += 1;
        self.counts.add::<D::Color>(pixels(area));
        self.inner.fill_solid(area, color)
    }
}
