//! Text and pictures on pictures, by embedded-graphics.

use crate::shot::Picture;
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Baseline, Text};
use std::convert::Infallible;

impl OriginDimensions for Picture {
    fn size(&self) -> Size {
        Size::new(self.size[0], self.size[1])
    }
}

impl DrawTarget for Picture {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let [columns, rows] = self.size;
        for Pixel(Point { x, y }, color) in pixels {
            if (0..columns as i32).contains(&x) && (0..rows as i32).contains(&y) {
                let place = y as usize * columns as usize + x as usize;
                if let Some(pixel) = self.pixels.get_mut(place) {
                    *pixel = [color.r(), color.g(), color.b()];
                }
            }
        }
        Ok(())
    }
}

impl Picture {
    /// Makes a picture of one colour.
    pub fn filled(size: [u32; 2], color: [u8; 3]) -> Self {
        Self { size, pixels: vec![color; size[0] as usize * size[1] as usize] }
    }

    /// Writes a line of white text; what does not fit is cut off.
    pub fn write_text(&mut self, text: &str, corner: [u32; 2], font: &MonoFont<'_>) {
        let style = MonoTextStyle::new(font, Rgb888::WHITE);
        let corner = Point::new(corner[0] as i32, corner[1] as i32);
        let Ok(_) = Text::with_baseline(text, corner, style, Baseline::Top).draw(self);
    }

    /// Lays another picture over this one; what does not fit is cut off.
    pub fn paste(&mut self, picture: &Picture, corner: [u32; 2]) {
        let columns = picture.size[0].max(1);
        let pixels = picture.pixels.iter().enumerate().map(|(i, [r, g, b])| {
            let (x, y) = (i as u32 % columns + corner[0], i as u32 / columns + corner[1]);
            Pixel(Point::new(x as i32, y as i32), Rgb888::new(*r, *g, *b))
        });
        let Ok(()) = self.draw_iter(pixels);
    }

    /// Darkens a rectangle to a quarter, so that text on it can be read.
    pub fn darken(&mut self, [left, top]: [u32; 2], [width, height]: [u32; 2]) {
        let columns = self.size[0].max(1);
        for (i, pixel) in self.pixels.iter_mut().enumerate() {
            let (x, y) = (i as u32 % columns, i as u32 / columns);
            if (left..left + width).contains(&x) && (top..top + height).contains(&y) {
                *pixel = pixel.map(|level| level / 4);
            }
        }
    }

    /// Enlarges or shrinks a picture by taking the nearest pixel.
    pub fn resized(&self, size: [u32; 2]) -> Self {
        let [columns, rows] = self.size;
        let nearest = |(x, y): (u32, u32)| {
            let place = (y * rows / size[1]) * columns + x * columns / size[0];
            self.pixels.get(place as usize).copied().unwrap_or_default()
        };
        let places = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y)));
        Self { size, pixels: places.map(nearest).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::mono_font::ascii::FONT_4X6;

    #[test]
    fn pasting_puts_a_picture_in_place_and_cuts_off_what_hangs_over() {
        let mut board = Picture::filled([3, 2], [0; 3]);
        board.paste(&Picture::filled([2, 2], [9; 3]), [2, 1]);
        assert_eq!(board.pixels, [[0; 3], [0; 3], [0; 3], [0; 3], [0; 3], [9; 3]]);
    }

    #[test]
    fn text_is_white_and_stays_inside() {
        let mut board = Picture::filled([10, 6], [0; 3]);
        board.write_text("too long to fit", [0, 0], &FONT_4X6);
        assert_eq!(board.pixels.len(), 60);
        assert!(board.pixels.contains(&[255; 3]) && board.pixels.contains(&[0; 3]));
    }

    #[test]
    fn darkening_spares_what_lies_outside() {
        let mut board = Picture::filled([2, 1], [200; 3]);
        board.darken([0, 0], [1, 1]);
        assert_eq!(board.pixels, [[50; 3], [200; 3]]);
    }

    #[test]
    fn enlarging_twice_makes_squares_of_four() {
        let small = Picture { size: [2, 1], pixels: vec![[1; 3], [2; 3]] };
        let large = small.resized([4, 2]);
        assert_eq!(large.pixels, [[1; 3], [1; 3], [2; 3], [2; 3], [1; 3], [1; 3], [2; 3], [2; 3]]);
        assert_eq!(large.resized([2, 1]), small);
    }
}
