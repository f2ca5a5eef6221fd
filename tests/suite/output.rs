//! Light becomes panel levels by the published curve, and rounding keeps the mean.

use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb666, Rgb888};
use embedded_graphics::prelude::*;
use scanray::output::Quantizer;
use scanray::{Dither, Encode, Fixed, Rgb, Transfer};

/// Is the curve of IEC 61966-2-1.
fn srgb(light: f64) -> f64 {
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

#[test]
fn the_transfer_table_keeps_to_the_curve_on_both_sides() {
    let mut worst: f64 = 0.0;
    for bits in (0..=1 << 24).step_by(61).chain([1 << 24, 52_526, 52_527]) {
        let level = f64::from(Transfer::Srgb.level(bits)) / 65_536.0;
        let exact = srgb(f64::from(bits) / 16_777_216.0);
        worst = worst.max((level - exact).abs());
        let linear = f64::from(Transfer::Linear.level(bits)) / 65_536.0;
        assert!((linear - f64::from(bits) / 16_777_216.0).abs() <= 1.0 / 65_536.0);
    }
    assert!((1e-5..3e-4).contains(&worst), "worst error {worst:e}");
}

#[test]
fn the_transfer_table_never_falls() {
    let levels = (0..=1_u32 << 24).step_by(17).map(|bits| Transfer::Srgb.level(bits));
    levels.fold(0, |before, level| {
        assert!(level >= before);
        level
    });
    assert_eq!(Transfer::Srgb.level(0), 0);
    assert_eq!(Transfer::Srgb.level(1 << 24), 1 << 16);
    assert_eq!(Transfer::Srgb.level(u32::MAX), 1 << 16);
}

fn every_place() -> impl Iterator<Item = (u32, u32)> {
    (0..8).flat_map(|y| (0..8).map(move |x| (x, y)))
}

fn encoded<C: Encode>(light: f32, dither: Dither, x: u32, y: u32) -> C {
    C::from_light(Rgb::gray(light), Quantizer::new(Transfer::Linear, dither, x, y))
}

#[test]
fn black_and_white_stay_whole_on_every_panel() {
    for (x, y) in every_place() {
        let d = Dither::Ordered;
        assert_eq!(encoded::<Rgb565>(0.0, d, x, y), Rgb565::BLACK);
        assert_eq!(encoded::<Rgb565>(1.0, d, x, y), Rgb565::WHITE);
        assert_eq!(encoded::<Rgb666>(1.0, d, x, y), Rgb666::WHITE);
        assert_eq!(encoded::<Rgb888>(9.0, d, x, y), Rgb888::WHITE);
        assert_eq!(encoded::<Gray8>(1.0, d, x, y), Gray8::WHITE);
        assert_eq!(encoded::<Gray4>(-1.0, d, x, y), Gray4::BLACK);
        assert_eq!(encoded::<Gray4>(1.0, d, x, y), Gray4::WHITE);
        assert_eq!(encoded::<BinaryColor>(0.0, d, x, y), BinaryColor::Off);
        assert_eq!(encoded::<BinaryColor>(1.0, d, x, y), BinaryColor::On);
    }
}

#[test]
fn the_mean_of_a_dithered_square_is_the_light_that_was_asked_for() {
    for i in 0..=64 {
        let light = i as f32 / 64.0;
        let mean =
            |level: &dyn Fn(u32, u32) -> f32| every_place().map(|(x, y)| level(x, y)).sum::<f32>() / 64.0;
        let gray = mean(&|x, y| f32::from(encoded::<Gray4>(light, Dither::Ordered, x, y).luma()) / 15.0);
        assert!((gray - light).abs() <= 0.6 / 64.0, "{light} became {gray}");
        let on =
            mean(&|x, y| f32::from(u8::from(encoded::<BinaryColor>(light, Dither::Ordered, x, y).is_on())));
        assert!((on - light).abs() <= 0.6 / 64.0, "{light} became {on}");
    }
}

#[test]
fn without_dithering_the_nearest_level_is_taken() {
    let level = |light| encoded::<Gray4>(light, Dither::None, 3, 5).luma();
    for i in 0..15_u8 {
        let (below, above) = (f32::from(i) + 0.49, f32::from(i) + 0.51);
        assert_eq!((level(below / 15.0), level(above / 15.0)), (i, i + 1));
    }
}

#[test]
fn greys_have_the_luminance_of_their_colours() {
    let gray = |r, g, b| {
        let quantizer = Quantizer::new(Transfer::Linear, Dither::None, 0, 0);
        Gray8::from_light(Rgb::<f32>::new(r, g, b), quantizer).luma()
    };
    // Rec. 709: 0.2126, 0.7152, 0.0722 of 255.
    assert_eq!([gray(1.0, 0.0, 0.0), gray(0.0, 1.0, 0.0), gray(0.0, 0.0, 1.0)], [54, 182, 18]);
    assert_eq!(gray(1.0, 1.0, 1.0), 255);
}

#[test]
fn bus_bytes_are_the_colour_with_the_high_byte_first() {
    let quantizer = Quantizer::new(Transfer::Linear, Dither::None, 0, 0);
    let light = Rgb::new(Fixed::new(1.0), Fixed::new(0.0), Fixed::new(1.0 / 31.0));
    assert_eq!(<[u8; 2]>::from_light(light, quantizer), [0b1111_1000, 0b0000_0001]);
}

#[test]
fn a_colour_is_the_rounding_of_its_levels() {
    fn check<C: Encode + PartialEq + core::fmt::Debug>() {
        for light in (0..1 << 25).step_by(9973).map(|n| [n, n / 2, (1 << 24) - n / 3]) {
            for transfer in [Transfer::Srgb, Transfer::Linear] {
                let levels = C::levels(light, transfer);
                for threshold in [0, 1 << 9, 1 << 15, u16::MAX] {
                    let color = C::from_levels(levels, u32::from(threshold));
                    assert_eq!(
                        C::encode(light, Quantizer::of_threshold(transfer, threshold)),
                        color,
                        "{light:?}"
                    );
                }
            }
        }
    }
    check::<Rgb565>();
    check::<Rgb666>();
    check::<Rgb888>();
    check::<Gray8>();
    check::<Gray4>();
    check::<BinaryColor>();
    check::<[u8; 2]>();
}
