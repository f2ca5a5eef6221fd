//! Each way of rounding keeps the mean, leaves black and white whole, and does not care for the order in
//! which a picture is drawn.

use crate::support::{camera, is_a_row, panel, pixels, scene};
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use scanray::output::{BLUE_NOISE, Rounding};
use scanray::{Adaptive, Dither, Encode, Quality, Renderer, Settings, Transfer, Workspace};

const BLUE: Dither = Dither::Mask(&BLUE_NOISE);
const ALL: [Dither; 4] = [Dither::None, Dither::Ordered, BLUE, Dither::Diffused];

/// Answers the levels of a part of row `y` of a picture that is the same grey everywhere.
fn row<C: Encode>(level: u32, dither: Dither, y: u32, length: u32) -> Vec<C> {
    let mut rounding = Rounding::of_row(dither, y);
    (0..length).map(|x| rounding.round(x, [level; 3])).collect()
}

fn greys() -> impl Iterator<Item = u32> {
    (0..=1_u32 << 16).step_by(97).chain([1 << 16])
}

fn mean(levels: &[Gray4]) -> f64 {
    levels.iter().map(|color| f64::from(color.luma())).sum::<f64>() / levels.len() as f64
}

#[test]
fn the_square_of_blue_noise_has_the_mean_of_every_grey() {
    for level in greys() {
        let square: Vec<Gray4> = (0..16).flat_map(|y| row(level, BLUE, y, 16)).collect();
        let (mean, wanted) = (mean(&square), f64::from(level) * 15.0 / 65_536.0);
        assert!((mean - wanted).abs() <= 0.501 / 256.0, "{wanted} became {mean}");
    }
}

#[test]
fn each_threshold_of_the_blue_noise_comes_once() {
    let mut ranks: Vec<u16> = BLUE_NOISE.as_flattened().to_vec();
    ranks.sort_unstable();
    assert!(ranks.iter().zip(0..).all(|(threshold, rank)| *threshold == (2 * rank + 1) << 7));
}

#[test]
fn every_part_of_a_diffused_row_has_the_mean_of_every_grey_within_a_level_of_one_pixel() {
    for level in greys() {
        let wanted = f64::from(level) * 15.0 / 65_536.0;
        let row = row::<Gray4>(level, Dither::Diffused, level % 61, 64);
        for (from, to) in [(0, 64), (0, 5), (11, 50), (63, 64)] {
            let part = &row[from..to];
            assert!((mean(part) - wanted).abs() <= 1.0 / part.len() as f64, "{wanted} in {from}..{to}");
        }
    }
}

#[test]
fn columns_of_diffused_rows_have_the_mean_too_so_that_no_stripes_stand_out() {
    for level in greys() {
        let wanted = f64::from(level) * 15.0 / 65_536.0;
        let rows: Vec<Vec<Gray4>> = (0..32).map(|y| row(level, Dither::Diffused, y, 64)).collect();
        for x in 0..64 {
            let column: Vec<Gray4> = rows.iter().map(|row| row[x]).collect();
            assert!((mean(&column) - wanted).abs() <= 0.07, "{wanted} in column {x}");
        }
    }
}

#[test]
fn each_channel_hands_on_its_own_remainder() {
    let levels = [65_536 / 31 / 4, 65_536 / 63 / 2, 65_536 / 31 / 8];
    let mut rounding = Rounding::of_row(Dither::Diffused, 3);
    let row: Vec<Rgb565> = (0..800).map(|x| rounding.round(x, levels)).collect();
    let sum = |channel: fn(&Rgb565) -> u8| row.iter().map(|color| u32::from(channel(color))).sum::<u32>();
    let sums = [sum(RgbColor::r), sum(RgbColor::g), sum(RgbColor::b)];
    // 800 pixels of a quarter, a half and an eighth of a step, less what 16 bits round off.
    for (found, wanted) in sums.into_iter().zip([200, 400, 100]) {
        assert!(found.abs_diff(wanted) <= 1, "{sums:?}");
    }
}

#[test]
fn black_and_white_stay_whole_in_every_way() {
    for dither in ALL {
        for y in 0..20 {
            assert!(row::<BinaryColor>(0, dither, y, 40).iter().all(|color| color.is_off()), "{dither:?}");
            assert!(row::<BinaryColor>(1 << 16, dither, y, 40).iter().all(|color| color.is_on()));
            assert!(row::<Rgb565>(1 << 16, dither, y, 40).iter().all(|color| *color == Rgb565::WHITE));
        }
    }
}

#[test]
fn light_is_rounded_as_its_levels_are() {
    for dither in ALL {
        let (mut encoding, mut rounding) = (Rounding::of_row(dither, 7), Rounding::of_row(dither, 7));
        for x in 0..64 {
            let light = [x << 17, x << 18, (64 - x) << 18];
            let levels = Rgb565::levels(light, Transfer::Srgb);
            let (encoded, rounded): (Rgb565, Rgb565) =
                (encoding.encode(x, light, Transfer::Srgb), rounding.round(x, levels));
            assert_eq!(encoded, rounded, "{dither:?}, column {x}");
        }
    }
}

fn check_parts(settings: Settings<f32, impl Quality>) {
    let size = Size::new(61, 30);
    let mut workspace = Workspace::<f32, Gray4, 61, 2>::new();
    let mut renderer = Renderer::new(&scene(), &camera(), size, settings, &mut workspace).unwrap();
    let mut whole = panel(size).only(is_a_row);
    renderer.draw(&mut whole).unwrap();
    let mut tiled = panel(size).only(is_a_row);
    // From the right to the left, so that no remainder comes along by chance.
    for (x, y) in (0..30).step_by(7).flat_map(|y| (0..61).step_by(11).rev().map(move |x| (x, y))) {
        let part = Rectangle::new(Point::new(x, y), Size::new(11, 7));
        renderer.draw_part(&part, Point::zero(), &mut tiled).unwrap();
    }
    assert!(pixels(&tiled) == pixels(&whole), "{:?}", settings.dither);
    let mut row = [Gray4::BLACK; 61];
    for y in [29, 3, 17] {
        renderer.render_row(y, &mut row).unwrap();
        let drawn = pixels(&whole)[y as usize * 61..].iter().take(61).map(|pixel| pixel.unwrap());
        assert!(row.iter().copied().eq(drawn), "{:?}, row {y}", settings.dither);
    }
}

#[test]
fn parts_and_rows_in_any_order_are_the_whole_picture_in_every_way_and_quality() {
    for dither in ALL {
        let settings = Settings::new().with_depth(2).with_dither(dither);
        check_parts(settings);
        check_parts(settings.with_quality(Adaptive));
    }
}
