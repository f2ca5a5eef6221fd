use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Dimensions;
use embedded_graphics_core::primitives::Rectangle;

use crate::call::{Call, covers, pixels};

/// Panics where a real display would show garbage or nothing: at pixels outside of it, at areas without pixels, and
/// at fills with more or fewer colours than pixels, which shift whatever comes after them.
///
/// Colours are counted when the display within is done; where it fails they are not.
#[derive(Clone, Debug)]
pub struct Strict<D> {
    inner: D,
    allowed: fn(&Call) -> bool,
}

impl<D> Strict<D> {
    /// Watches over a display.
    pub const fn new(inner: D) -> Self {
        Self { inner, allowed: |_| true }
    }

    /// Panics at every other call than those for which the function answers true, too.
    #[must_use]
    pub const fn only(mut self, allowed: fn(&Call) -> bool) -> Self {
        self.allowed = allowed;
        self
    }

    /// Answers the display within.
    pub const fn inner(&self) -> &D {
        &self.inner
    }
}

impl<D: Dimensions> Strict<D> {
    fn check(&self, call: &Call) {
        assert!((self.allowed)(call), "not one of the calls allowed: {call:?}");
        let Some(area) = call.area() else { return };
        assert!(!area.is_zero_sized(), "an area without pixels: {area:?}");
        let all = self.inner.bounding_box();
        assert!(covers(&all, &area), "{area:?} reaches beyond {all:?}");
    }
}

impl<D: Dimensions> Dimensions for Strict<D> {
    fn bounding_box(&self) -> Rectangle {
        self.inner.bounding_box()
    }
}

impl<D: DrawTarget> DrawTarget for Strict<D> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        self.check(&Call::Pixels);
        let all = self.bounding_box();
        self.inner.draw_iter(pixels.into_iter().inspect(|Pixel(point, _)| {
            assert!(all.contains(*point), "pixel ({}, {}) is outside of {all:?}", point.x, point.y);
        }))
    }

    fn fill_contiguous<I: IntoIterator<Item = D::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), D::Error> {
        self.check(&Call::Contiguous(*area));
        let (expected, mut count) = (pixels(area), 0);
        // One more than there should be: a colour too many is found, and an endless list has an end.
        let mut colors = colors.into_iter().zip(0..=expected).map(|(color, _)| color).inspect(|_| count += 1);
        self.inner.fill_contiguous(area, &mut colors)?;
        colors.by_ref().for_each(drop);
        assert!(count <= expected, "more colours than the {expected} pixels of {area:?}");
        assert!(count == expected, "{count} colours for the {expected} pixels of {area:?}");
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), D::Error> {
        self.check(&Call::Solid(*area));
        self.inner.fill_solid(area, color)
    }
}
