use core::iter;
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Dimensions;
use embedded_graphics_core::primitives::Rectangle;

use crate::call::pixels;

/// Says when a display fails. Calls and pixels are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum At {
    /// Fails before the call of this number does anything.
    Call(u64),
    /// Fails in the middle of a call: the pixels before the one of this number are on the display.
    Pixel(u64),
}

/// Is a count that never comes to its end.
const NEVER: u64 = u64::MAX;

/// Fails with an error of the user's, once or from then on.
#[derive(Clone, Debug)]
pub struct Failing<D: DrawTarget> {
    inner: D,
    calls_left: u64,
    pixels_left: u64,
    error: D::Error,
    recovers: bool,
    failures: u64,
}

impl<D: DrawTarget<Error: Clone>> Failing<D> {
    /// Makes a display that fails once, as of a loose wire, and works again.
    pub const fn once(inner: D, at: At, error: D::Error) -> Self {
        Self::new(inner, at, error, true)
    }

    /// Makes a display that works up to a point and never again.
    pub const fn from_then_on(inner: D, at: At, error: D::Error) -> Self {
        Self::new(inner, at, error, false)
    }

    const fn new(inner: D, at: At, error: D::Error, recovers: bool) -> Self {
        let (calls_left, pixels_left) = match at {
            At::Call(number) => (number, NEVER),
            At::Pixel(number) => (NEVER, number),
        };
        Self { inner, calls_left, pixels_left, error, recovers, failures: 0 }
    }

    /// Answers how many calls have failed.
    pub const fn failures(&self) -> u64 {
        self.failures
    }

    /// Answers the display within.
    pub const fn inner(&self) -> &D {
        &self.inner
    }

    fn begin(&mut self) -> Result<(), D::Error> {
        if self.calls_left == 0 {
            return Err(self.fail());
        }
        self.calls_left = self.calls_left.saturating_sub(1);
        Ok(())
    }

    fn fail(&mut self) -> D::Error {
        self.failures += 1;
        if self.recovers {
            (self.calls_left, self.pixels_left) = (NEVER, NEVER);
        }
        self.error.clone()
    }

    /// Hands on the items that are before the failure; an error of the display within comes first.
    fn pass<T>(
        &mut self,
        items: impl IntoIterator<Item = T>,
        draw: impl FnOnce(&mut D, &mut dyn Iterator<Item = T>) -> Result<(), D::Error>,
    ) -> Result<(), D::Error> {
        self.begin()?;
        let (mut items, mut cut) = (items.into_iter(), false);
        let (left, inner) = (&mut self.pixels_left, &mut self.inner);
        let mut before = iter::from_fn(|| {
            let item = if cut { None } else { items.next() }?;
            cut = *left == 0;
            *left = left.saturating_sub(1);
            if cut { None } else { Some(item) }
        });
        draw(inner, &mut before)?;
        if cut { Err(self.fail()) } else { Ok(()) }
    }
}

impl<D: DrawTarget> Dimensions for Failing<D> {
    fn bounding_box(&self) -> Rectangle {
        self.inner.bounding_box()
    }
}

impl<D: DrawTarget<Error: Clone>> DrawTarget for Failing<D> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        self.pass(pixels, |inner, pixels| inner.draw_iter(pixels))
    }

    fn fill_contiguous<I: IntoIterator<Item = D::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), D::Error> {
        self.pass(colors, |inner, colors| inner.fill_contiguous(area, colors))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), D::Error> {
        let Some(left) = self.pixels_left.checked_sub(pixels(area)) else {
            let colors = (0..pixels(area)).map(|_| color);
            return self.pass(colors, |inner, colors| inner.fill_contiguous(area, colors));
        };
        self.begin()?;
        self.pixels_left = left;
        self.inner.fill_solid(area, color)
    }
}
