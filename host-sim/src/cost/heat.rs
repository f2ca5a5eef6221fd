use super::{Map, What};
use crate::shot::Picture;
use embedded_graphics::mono_font::ascii::FONT_9X15;

/// Is what is left free around the pictures, and how high the foot with the scale is.
const MARGIN: u32 = 12;
const HEAD: u32 = 26;
const FOOT: u32 = 62;
/// Is how high the scale itself is.
const SCALE: u32 = 18;
/// Is how wide a character of the font is.
const LETTER: u32 = 9;
const PAPER: [u8; 3] = [22, 24, 28];

/// Is the share of the pixels above which all have the brightest colour: a few very dear ones would else leave all
/// others dark.
const BRIGHTEST: f64 = 0.005;

/// Draws a map of what the pixels take beside the picture they make, with the scale of its colours below.
///
/// Colours are those of viridis (S. van der Walt, N. Smith 2015): equal steps of the value look equal, in print and
/// to the colour-blind too.
pub fn heat(map: &Map, what: What, picture: &Picture) -> Picture {
    let values: Vec<u64> = map.pixels.iter().map(|bill| what.of(bill)).collect();
    let (top, most) = top(&values);
    let scale = if map.size[0] <= 400 { 2 } else { 1 };
    let [width, height] = map.size.map(|side| side * scale);
    let heat = Picture { size: map.size, pixels: values.iter().map(|value| color(*value, top)).collect() };
    let mut page = Picture::filled([2 * width + 3 * MARGIN, HEAD + height + FOOT], PAPER);
    let right = width + 2 * MARGIN;
    page.paste(&picture.resized([width, height]), [MARGIN, HEAD]);
    page.paste(&heat.resized([width, height]), [right, HEAD]);
    page.write_text("the picture", [MARGIN, 6], &FONT_9X15);
    page.write_text(&format!("{} of each pixel", what.name()), [right, 6], &FONT_9X15);
    let bar = Picture { size: [width, SCALE], pixels: ramp(width) };
    let below = HEAD + height + MARGIN;
    page.paste(&bar, [right, below]);
    let last = if most > top { format!("{top} and more") } else { top.to_string() };
    // On a small picture the labels begin further left than its map.
    let from = (right + width).saturating_sub(last.len() as u32 * LETTER);
    let half = (top / 2).to_string();
    let middle = (right + width / 2).saturating_sub(half.len() as u32 * LETTER / 2);
    for (label, left) in [("0", right), (half.as_str(), middle), (last.as_str(), from)] {
        page.write_text(label, [left, below + SCALE + 4], &FONT_9X15);
    }
    let mean = values.iter().sum::<u64>() as f64 / values.len().max(1) as f64;
    page.write_text(&format!("mean {mean:.1}, most {most}"), [MARGIN, below + 2], &FONT_9X15);
    page
}

/// Answers the value of the brightest colour, 1 at least, and the largest value.
fn top(values: &[u64]) -> (u64, u64) {
    let mut sorted = values.to_vec();
    sorted.sort_unstable();
    let most = sorted.last().copied().unwrap_or(0);
    let above = (BRIGHTEST * values.len() as f64) as usize;
    let top = sorted.iter().rev().nth(above).copied().unwrap_or(most);
    (top.max(1), most)
}

fn color(value: u64, top: u64) -> [u8; 3] {
    let share = (value as f64 / top as f64).min(1.0);
    colorous::VIRIDIS.eval_continuous(share).as_array()
}

/// Answers the colours of a scale from left to right.
fn ramp(width: u32) -> Vec<[u8; 3]> {
    let row = (0..width).map(|x| color(u64::from(x), u64::from(width.max(2) - 1)));
    row.cycle().take((width * SCALE) as usize).collect()
}
