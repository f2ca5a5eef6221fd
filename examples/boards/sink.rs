//! A panel that is only the end of a bus: it hands on what it is sent, a rowful at a time.

use core::convert::Infallible;
use embedded_graphics::{
    pixelcolor::{Rgb565, raw::ToBytes},
    prelude::*,
    primitives::Rectangle,
};

/// Is how many pixels are handed on together at most.
const ROOM: usize = 320;

/// Hands the colours it is sent, in the bytes of a display's bus, to `take`.
pub struct Sink<'t> {
    size: Size,
    sent: [[u8; 2]; ROOM],
    take: &'t mut dyn FnMut(&[[u8; 2]]),
}

impl<'t> Sink<'t> {
    /// Makes a panel of a size.
    pub fn new(size: Size, take: &'t mut dyn FnMut(&[[u8; 2]])) -> Self {
        Self { size, sent: [[0; 2]; ROOM], take }
    }
}

impl OriginDimensions for Sink<'_> {
    fn size(&self) -> Size {
        self.size
    }
}

impl DrawTarget for Sink<'_> {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let colors = pixels.into_iter().map(|Pixel(_, color)| color);
        self.fill_contiguous(&self.bounding_box(), colors)
    }

    fn fill_contiguous<I>(&mut self, _: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Rgb565>,
    {
        let mut colors = colors.into_iter();
        loop {
            let mut count = 0_usize;
            for (place, color) in self.sent.iter_mut().zip(&mut colors) {
                *place = color.to_be_bytes();
                // At most the room.
                count = count.wrapping_add(1);
            }
            match self.sent.get(..count) {
                None | Some([]) => return Ok(()),
                Some(sent) => (self.take)(sent),
            }
        }
    }
}
