//! What is written over the picture.

use super::keys::HELP;
use crate::shot::Picture;
use embedded_graphics::mono_font::MonoFont;
use embedded_graphics::mono_font::ascii::{FONT_4X6, FONT_6X10, FONT_9X15};

/// Is how far text stays from the edges.
const MARGIN: u32 = 4;

/// Is the column in which the help's second words begin.
const SECOND: usize = 14;

/// Writes the keys over the picture.
pub fn help(picture: &mut Picture) {
    let lines: Vec<String> = HELP.iter().map(|[key, what]| format!("{key:SECOND$}{what}")).collect();
    block(picture, &lines, [0, 0]);
}

/// Writes a message at the lower edge of the picture.
pub fn message(picture: &mut Picture, text: &str) {
    let font = font(picture, text.len(), 1);
    let line = font.character_size.height + 2 * MARGIN;
    block(picture, &[text.to_owned()], [0, picture.size[1].saturating_sub(line)]);
}

/// Answers the largest font in which so many lines of so many letters fit, or the smallest.
fn font(picture: &Picture, letters: usize, lines: usize) -> &'static MonoFont<'static> {
    let fits = |font: &&&MonoFont<'_>| {
        let size = font.character_size;
        let width = letters as u32 * size.width + 2 * MARGIN;
        let height = lines as u32 * size.height + 2 * MARGIN;
        width <= picture.size[0] && height <= picture.size[1]
    };
    // Large letters are for large pictures only, where the window is not scaled.
    let fonts: &[&MonoFont<'_>] =
        if picture.size[0] >= 640 { &[&FONT_9X15, &FONT_6X10] } else { &[&FONT_6X10] };
    fonts.iter().find(fits).copied().unwrap_or(&FONT_4X6)
}

fn block(picture: &mut Picture, lines: &[String], [left, top]: [u32; 2]) {
    let letters = lines.iter().map(String::len).max().unwrap_or(0);
    let font = font(picture, letters, lines.len());
    let size = font.character_size;
    let width = letters as u32 * size.width + 2 * MARGIN;
    let height = lines.len() as u32 * size.height + 2 * MARGIN;
    picture.darken([left, top], [width, height]);
    for (line, y) in lines.iter().zip((top + MARGIN..).step_by(size.height as usize)) {
        picture.write_text(line, [left + MARGIN, y], font);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn white_pixels(picture: &Picture) -> usize {
        picture.pixels.iter().filter(|pixel| **pixel == [255; 3]).count()
    }

    #[test]
    fn the_help_fits_the_gallerys_pictures_whole() {
        let on = |size| {
            let mut picture = Picture::filled(size, [100; 3]);
            help(&mut picture);
            white_pixels(&picture)
        };
        // A line that is cut off would be missing some white.
        assert_eq!(on([240, 240]), on([600, 600]));
        assert_eq!(on([128, 96]), on([128, 128]));
    }

    #[test]
    fn a_message_stands_at_the_lower_edge() {
        let mut picture = Picture::filled([240, 100], [100; 3]);
        message(&mut picture, "saved simple.png");
        let changed: Vec<usize> = (0..240 * 100).filter(|i| picture.pixels[*i] != [100; 3]).collect();
        assert_eq!((changed.first(), changed.last().map(|i| i / 240)), (Some(&(240 * 82)), Some(99)));
        assert!(white_pixels(&picture) > 50);
    }

    #[test]
    fn even_a_picture_of_one_pixel_survives_the_help() {
        help(&mut Picture::filled([1, 1], [0; 3]));
        message(&mut Picture::filled([1, 1], [0; 3]), "saved");
    }
}
