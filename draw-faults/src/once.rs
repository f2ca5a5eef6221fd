use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point};
use embedded_graphics_core::primitives::{PointsIter, Rectangle};

use crate::call::pixels;

/// Panics when a pixel is drawn a second time, and says which pixels were not drawn at all.
///
/// `B` is the memory of which were drawn: `Vec<bool>`, `[bool; N]` or `&mut [bool]`, a place for each pixel. Pixels
/// outside of the display are none of its concern ([`Strict`](crate::Strict) looks after them).
#[derive(Clone, Debug)]
pub struct Once<D, B> {
    inner: D,
    drawn: B,
}

impl<D: Dimensions, B: AsRef<[bool]> + AsMut<[bool]>> Once<D, B> {
    /// Begins with a display of which nothing is drawn.
    ///
    /// # Panics
    /// When the memory does not have one place for each pixel.
    pub fn new(inner: D, memory: B) -> Self {
        let (places, size) = (memory.as_ref().len(), inner.bounding_box().size);
        assert!(places as u64 == pixels(&inner.bounding_box()), "{places} places for the pixels of {size:?}");
        let mut new = Self { inner, drawn: memory };
        new.restart();
        new
    }

    /// Forgets what was drawn: a new picture begins, or after an error the same one anew.
    pub fn restart(&mut self) {
        self.drawn.as_mut().fill(false);
    }

    /// Answers the pixels that were not drawn, row by row.
    pub fn missing(&self) -> impl Iterator<Item = Point> + '_ {
        let places = self.drawn.as_ref().iter();
        self.inner.bounding_box().points().zip(places).filter(|(_, drawn)| !**drawn).map(|(point, _)| point)
    }

    /// Checks that every pixel was drawn.
    ///
    /// # Panics
    /// When one was not; it names the first and says how many there are.
    #[track_caller]
    pub fn assert_complete(&self) {
        if let Some(Point { x, y }) = self.missing().next() {
            panic!("{} pixels are not drawn, the first at ({x}, {y})", self.missing().count());
        }
    }

    /// Answers the display within.
    pub const fn inner(&self) -> &D {
        &self.inner
    }
}

/// Takes note that a pixel of an area is drawn.
fn mark(drawn: &mut [bool], area: &Rectangle, point: Point) {
    if !area.contains(point) {
        return;
    }
    let Point { x, y } = point - area.top_left;
    let place = drawn.get_mut(y as usize * area.size.width as usize + x as usize);
    let before = place.is_some_and(|place| core::mem::replace(place, true));
    assert!(!before, "pixel ({}, {}) is drawn a second time", point.x, point.y);
}

impl<D: Dimensions, B> Dimensions for Once<D, B> {
    fn bounding_box(&self) -> Rectangle {
        self.inner.bounding_box()
    }
}

impl<D: DrawTarget, B: AsRef<[bool]> + AsMut<[bool]>> DrawTarget for Once<D, B> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        let (all, drawn) = (self.bounding_box(), self.drawn.as_mut());
        self.inner.draw_iter(pixels.into_iter().inspect(|Pixel(point, _)| mark(drawn, &all, *point)))
    }

    fn fill_contiguous<I: IntoIterator<Item = D::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), D::Error> {
        let (all, drawn, mut points) = (self.bounding_box(), self.drawn.as_mut(), area.points());
        let colors = colors.into_iter().inspect(|_| {
            if let Some(point) = points.next() {
                mark(drawn, &all, point);
            }
        });
        self.inner.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), D::Error> {
        self.inner.fill_solid(area, color)?;
        let (all, drawn) = (self.bounding_box(), self.drawn.as_mut());
        area.points().for_each(|point| mark(drawn, &all, point));
        Ok(())
    }
}
