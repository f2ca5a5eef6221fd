use core::convert::Infallible;
use core::marker::PhantomData;
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Dimensions;
use embedded_graphics_core::primitives::Rectangle;

/// Gives a display that cannot fail, such as `MockDisplay`, an error type `E` of the user's, so that one that fails
/// can be put around it.
#[derive(Clone, Debug)]
pub struct Fallible<D, E> {
    inner: D,
    error: PhantomData<fn() -> E>,
}

impl<D, E> Fallible<D, E> {
    /// Wraps a display.
    pub const fn new(inner: D) -> Self {
        Self { inner, error: PhantomData }
    }

    /// Answers the display within.
    pub const fn inner(&self) -> &D {
        &self.inner
    }
}

impl<D: Dimensions, E> Dimensions for Fallible<D, E> {
    fn bounding_box(&self) -> Rectangle {
        self.inner.bounding_box()
    }
}

impl<D: DrawTarget<Error = Infallible>, E> DrawTarget for Fallible<D, E> {
    type Color = D::Color;
    type Error = E;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), E> {
        let Ok(()) = self.inner.draw_iter(pixels);
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = D::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), E> {
        let Ok(()) = self.inner.fill_contiguous(area, colors);
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), E> {
        let Ok(()) = self.inner.fill_solid(area, color);
        Ok(())
    }
}
