use core::convert::Infallible;
use core::marker::PhantomData;
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point};
use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_graphics_core::primitives::Rectangle;

use crate::call::pixels;

/// Is a display of any size that keeps its pixels, leaves out what lies beyond its edges and never fails.
///
/// `B` is the memory: `Vec<Option<C>>`, `[Option<C>; N]` or `&mut [Option<C>]`, row by row; `None` is a pixel that
/// nobody has drawn. `E` is the error type that the displays around it shall have.
#[derive(Clone, Debug)]
pub struct Canvas<C, B, E = Infallible> {
    area: Rectangle,
    pixels: B,
    kind: PhantomData<fn() -> (C, E)>,
}

impl<C: PixelColor, B: AsRef<[Option<C>]> + AsMut<[Option<C>]>, E> Canvas<C, B, E> {
    /// Makes a display of an area, which need not begin at zero.
    ///
    /// # Panics
    /// When the memory does not have one place for each pixel of the area.
    pub fn new(area: Rectangle, memory: B) -> Self {
        let places = memory.as_ref().len();
        assert!(places as u64 == pixels(&area), "{places} places for the pixels of {:?}", area.size);
        Self { area, pixels: memory, kind: PhantomData }
    }

    /// Answers the pixels, row by row; nothing where none was drawn.
    pub fn pixels(&self) -> &[Option<C>] {
        self.pixels.as_ref()
    }

    /// Answers the pixel at a point of the display; nothing where none was drawn.
    pub fn pixel(&self, point: Point) -> Option<C> {
        self.pixels().get(self.place(point)?).copied().flatten()
    }

    /// Tells whether every pixel was drawn.
    pub fn is_full(&self) -> bool {
        self.pixels().iter().all(Option::is_some)
    }

    fn place(&self, point: Point) -> Option<usize> {
        let off = |at: i32, start: i32, end: u32| {
            u32::try_from(i64::from(at) - i64::from(start)).ok().filter(|off| *off < end)
        };
        let column = off(point.x, self.area.top_left.x, self.area.size.width)?;
        let row = off(point.y, self.area.top_left.y, self.area.size.height)?;
        Some(row as usize * self.area.size.width as usize + column as usize)
    }
}

impl<C, B, E> Dimensions for Canvas<C, B, E> {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl<C: PixelColor, B: AsRef<[Option<C>]> + AsMut<[Option<C>]>, E> DrawTarget for Canvas<C, B, E> {
    type Color = C;
    type Error = E;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), E> {
        for Pixel(point, color) in pixels {
            let place = self.place(point);
            if let Some(pixel) = place.and_then(|place| self.pixels.as_mut().get_mut(place)) {
                *pixel = Some(color);
            }
        }
        Ok(())
    }
}
