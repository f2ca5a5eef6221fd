use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Dimensions;
use embedded_graphics_core::primitives::Rectangle;

/// Answers "would block" for some calls, as a bus that somebody else is using, and then works.
///
/// A call that stalls does nothing: whoever repeats it loses nothing.
#[derive(Clone, Debug)]
pub struct Stalling<D: DrawTarget> {
    inner: D,
    /// How many calls stall in a row, how many then work, and how many of either are to come.
    times: u64,
    every: u64,
    stalls_left: u64,
    calls_left: u64,
    error: D::Error,
    stalls: u64,
}

impl<D: DrawTarget<Error: Clone>> Stalling<D> {
    /// Makes a display whose first calls stall, so many of them; the others work.
    pub const fn new(inner: D, times: u64, error: D::Error) -> Self {
        Self { inner, times, every: u64::MAX, stalls_left: times, calls_left: u64::MAX, error, stalls: 0 }
    }

    /// Stalls again, as often as at first, whenever so many calls have worked; 0 counts as 1.
    #[must_use]
    pub const fn every(mut self, calls: u64) -> Self {
        self.every = if calls == 0 { 1 } else { calls };
        self.calls_left = self.every;
        self
    }

    /// Answers how many calls have stalled.
    pub const fn stalls(&self) -> u64 {
        self.stalls
    }

    /// Answers the display within.
    pub const fn inner(&self) -> &D {
        &self.inner
    }

    fn begin(&mut self) -> Result<(), D::Error> {
        if self.stalls_left > 0 {
            self.stalls_left -= 1;
            self.stalls += 1;
            return Err(self.error.clone());
        }
        self.calls_left -= 1;
        if self.calls_left == 0 {
            (self.calls_left, self.stalls_left) = (self.every, self.times);
        }
        Ok(())
    }
}

impl<D: DrawTarget> Dimensions for Stalling<D> {
    fn bounding_box(&self) -> Rectangle {
        self.inner.bounding_box()
    }
}

impl<D: DrawTarget<Error: Clone>> DrawTarget for Stalling<D> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        self.begin()?;
        self.inner.draw_iter(pixels)
    }

    fn fill_contiguous<I: IntoIterator<Item = D::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), D::Error> {
        self.begin()?;
        self.inner.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), D::Error> {
        self.begin()?;
        self.inner.fill_solid(area, color)
    }
}
