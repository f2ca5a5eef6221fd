use core::iter;
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Dimensions;
use embedded_graphics_core::primitives::Rectangle;

use crate::call::Call;

/// Keeps a list of the calls of a display, failed ones included, in any collection: `Vec<Call>`, or one of fixed room.
#[derive(Clone, Debug)]
pub struct Logging<D, L> {
    inner: D,
    calls: L,
}

impl<D, L: Extend<Call>> Logging<D, L> {
    /// Adds the calls of a display to a list.
    pub const fn new(inner: D, calls: L) -> Self {
        Self { inner, calls }
    }

    /// Answers the list of calls.
    pub const fn calls(&self) -> &L {
        &self.calls
    }

    /// Answers the display within.
    pub const fn inner(&self) -> &D {
        &self.inner
    }

    fn note(&mut self, call: Call) {
        self.calls.extend(iter::once(call));
    }
}

impl<D: Dimensions, L> Dimensions for Logging<D, L> {
    fn bounding_box(&self) -> Rectangle {
        self.inner.bounding_box()
    }
}

impl<D: DrawTarget, L: Extend<Call>> DrawTarget for Logging<D, L> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        self.note(Call::Pixels);
        self.inner.draw_iter(pixels)
    }

    fn fill_contiguous<I: IntoIterator<Item = D::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), D::Error> {
        self.note(Call::Contiguous(*area));
        self.inner.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), D::Error> {
        self.note(Call::Solid(*area));
        self.inner.fill_solid(area, color)
    }
}
