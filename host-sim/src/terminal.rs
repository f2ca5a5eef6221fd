//! Pictures in a terminal: two pixels to a character.

use crate::shot::Picture;
use std::fmt::Write;

/// Names what a terminal can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Half blocks in 24-bit colour.
    Color,
    /// Letters of more or less ink, on a dark ground.
    Letters,
}

/// Is the ink of letters from dark to light.
const INK: &[u8] = b" .:-=+*#%@";

/// Draws a picture no larger than so many columns and lines of a terminal.
pub fn preview(picture: &Picture, columns: u32, lines: u32, style: Style) -> String {
    let small = shrink(picture, columns, 2 * lines);
    let width = small.size[0] as usize;
    let rows: Vec<&[[u8; 3]]> = small.pixels.chunks(width).collect();
    let mut text = String::new();
    for pair in rows.chunks(2) {
        match style {
            Style::Color => half_blocks(&mut text, pair[0], pair.get(1).copied()),
            Style::Letters => letters(&mut text, pair[0], pair.get(1).copied()),
        }
        text.push('\n');
    }
    text
}

/// Writes a line of upper half blocks; the lower halves are the background.
fn half_blocks(text: &mut String, upper: &[[u8; 3]], lower: Option<&[[u8; 3]]>) {
    for (i, [r, g, b]) in upper.iter().enumerate() {
        // Writing to a `String` cannot fail.
        let _ = write!(text, "\x1b[38;2;{r};{g};{b}");
        if let Some([r, g, b]) = lower.and_then(|lower| lower.get(i)) {
            let _ = write!(text, ";48;2;{r};{g};{b}");
        }
        text.push_str("m\u{2580}");
    }
    text.push_str("\x1b[0m");
}

fn letters(text: &mut String, upper: &[[u8; 3]], lower: Option<&[[u8; 3]]>) {
    for (i, above) in upper.iter().enumerate() {
        let below = lower.and_then(|lower| lower.get(i)).unwrap_or(above);
        let brightness: usize = above.iter().chain(below).map(|level| usize::from(*level)).sum();
        text.push(char::from(INK[brightness * (INK.len() - 1) / (6 * 255)]));
    }
}

/// Shrinks a picture into a box, shape kept; each pixel is the mean of those it stands for.
fn shrink(picture: &Picture, columns: u32, rows: u32) -> Picture {
    let [width, height] = picture.size;
    let (columns, rows) = (columns.clamp(1, width), rows.clamp(1, height));
    let fits_by_width = u64::from(columns) * u64::from(height) <= u64::from(rows) * u64::from(width);
    let size = if fits_by_width {
        [columns, (columns * height / width).max(1)]
    } else {
        [(rows * width / height).max(1), rows]
    };
    let span = |i: u32, to: u32, from: u32| (i * from / to)..((i + 1) * from / to);
    let mean = |x: u32, y: u32| {
        let (xs, ys) = (span(x, size[0], width), span(y, size[1], height));
        let cells = ys.flat_map(|y| xs.clone().map(move |x| (y * width + x) as usize));
        mean_of(cells.filter_map(|i| picture.pixels.get(i)))
    };
    let pixels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))).map(|(x, y)| mean(x, y));
    Picture { size, pixels: pixels.collect() }
}

fn mean_of<'a>(pixels: impl Iterator<Item = &'a [u8; 3]>) -> [u8; 3] {
    let (mut sum, mut count) = ([0_u32; 3], 0);
    for pixel in pixels {
        count += 1;
        for (sum, level) in sum.iter_mut().zip(pixel) {
            *sum += u32::from(*level);
        }
    }
    sum.map(|sum| (sum / count.max(1)) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A red row, a green row, a blue row.
    fn flag() -> Picture {
        let rows = [[255, 0, 0], [0, 255, 0], [0, 0, 255]];
        Picture { size: [4, 3], pixels: rows.into_iter().flat_map(|color| [color; 4]).collect() }
    }

    #[test]
    fn two_rows_share_a_line_and_an_odd_last_one_has_no_background() {
        let text = preview(&flag(), 80, 40, Style::Color);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 2);
        assert_eq!(lines[0].matches("\x1b[38;2;255;0;0;48;2;0;255;0m\u{2580}").count(), 4);
        assert_eq!(lines[1].matches("\x1b[38;2;0;0;255m\u{2580}").count(), 4);
        assert!(lines.iter().all(|line| line.ends_with("\x1b[0m")));
    }

    #[test]
    fn a_preview_keeps_inside_its_box_and_keeps_its_shape() {
        let wide = Picture { size: [320, 240], pixels: vec![[9; 3]; 320 * 240] };
        let text = preview(&wide, 80, 100, Style::Letters);
        assert_eq!((text.lines().count(), text.lines().next().map(str::len)), (30, Some(80)));
        let text = preview(&wide, 80, 15, Style::Letters);
        assert_eq!((text.lines().count(), text.lines().next().map(str::len)), (15, Some(40)));
    }

    #[test]
    fn shrinking_takes_means() {
        let board = Picture { size: [2, 2], pixels: vec![[0; 3], [200; 3], [200; 3], [0; 3]] };
        assert_eq!(shrink(&board, 1, 1), Picture { size: [1, 1], pixels: vec![[100; 3]] });
    }

    #[test]
    fn letters_have_more_ink_where_it_is_lighter_and_no_escapes() {
        let steps = Picture { size: [3, 1], pixels: vec![[0; 3], [128; 3], [255; 3]] };
        assert_eq!(preview(&steps, 80, 1, Style::Letters), " =@\n");
    }
}
