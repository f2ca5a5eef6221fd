use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::mono_font::{MonoTextStyleBuilder, ascii::FONT_9X15_BOLD};
use embedded_graphics::pixelcolor::raw::{BigEndian, RawU16};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor, WebColors};
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Baseline, Text};

/// Is the letter F, which no turn and no mirror brings onto itself.
const F: [&str; 8] =
    ["........", ".#####..", ".#......", ".#......", ".####...", ".#......", ".#......", ".#......"];

/// Answers the colour of a pavement of letters F, sRGB levels.
pub(super) fn pavement(u: f64, v: f64) -> [f64; 3] {
    let texel = |share: f64| (share * 7.0).round() as usize;
    let stone = F[7 - texel(v)].as_bytes()[texel(u)];
    if stone == b'#' { [0.36, 0.42, 0.50] } else { [0.78, 0.74, 0.66] }
}

/// Draws the letters A, B, C, D, two by two: an image that tells left from right and up from down.
pub(super) fn letters() -> Vec<u8> {
    let mut image =
        Framebuffer::<Rgb565, RawU16, BigEndian, 32, 32, { buffer_size::<Rgb565>(32, 32) }>::new();
    let cells = [
        ("A", Rgb565::CSS_DARK_RED, [0, 0]),
        ("B", Rgb565::CSS_DARK_GOLDENROD, [16, 0]),
        ("C", Rgb565::CSS_SEA_GREEN, [0, 16]),
        ("D", Rgb565::CSS_ROYAL_BLUE, [16, 16]),
    ];
    for (letter, ground, [left, top]) in cells {
        let cell = Point::new(left, top);
        let area = embedded_graphics::primitives::Rectangle::new(cell, Size::new(16, 16));
        let style = MonoTextStyleBuilder::new().font(&FONT_9X15_BOLD).text_color(Rgb565::WHITE).build();
        let Ok(()) = image.fill_solid(&area, ground);
        let text = Text::with_baseline(letter, cell + Point::new(4, 1), style, Baseline::Top);
        let Ok(_) = text.draw(&mut image);
    }
    image.data().to_vec()
}
