//! A display that counts how often each of its pixels is written.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use std::convert::Infallible;

/// Is the side of a square that holds every picture with room around it.
const SIDE: usize = 40;

/// Counts the writes of each pixel, and those outside.
pub struct Canvas {
    writes: [[u16; SIDE]; SIDE],
    outside: usize,
}

impl Canvas {
    pub fn new() -> Self {
        Self { writes: [[0; SIDE]; SIDE], outside: 0 }
    }

    /// Tells whether the pixels of a picture in the upper left corner were written so often and no others were.
    pub fn holds(&self, [columns, rows]: [u32; 2], once: impl Fn(u16) -> bool) -> bool {
        let mut counts =
            self.writes.iter().enumerate().flat_map(|(y, row)| row.iter().enumerate().map(move |p| (y, p)));
        let is_right = |(y, (x, count)): (usize, (usize, &u16))| {
            let inside = x < columns as usize && y < rows as usize;
            if inside { once(*count) } else { *count == 0 }
        };
        self.outside == 0 && counts.all(is_right)
    }
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new_equal(SIDE as u32)
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(Point { x, y }, _) in pixels {
            let row = usize::try_from(y).ok().and_then(|y| self.writes.get_mut(y));
            let pixel = row.zip(usize::try_from(x).ok()).and_then(|(row, x)| row.get_mut(x));
            match pixel {
                Some(count) => *count += 1,
                None => self.outside += 1,
            }
        }
        Ok(())
    }
}
