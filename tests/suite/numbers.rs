//! The number types keep the error bounds their documentation states, on both sides.

use crate::bounds::{STEP, floats, steps, wide, worst_error};
use scanray::Fixed;
use scanray::math::{FixedWide, Scalar, Wide};

#[test]
fn the_root_of_a_float_is_right_on_both_sides() {
    worst_error(
        4e-7,
        floats().map(|x| {
            let exact = f64::from(x).sqrt();
            (f64::from(<f32 as Scalar>::sqrt(x)) - exact) / exact
        }),
    );
}

#[test]
fn the_root_of_a_double_is_right_on_both_sides() {
    worst_error(
        1e-15,
        floats().map(|x| {
            let exact = f64::from(x).sqrt();
            (<f64 as Scalar>::sqrt(f64::from(x)) - exact) / exact
        }),
    );
}

#[test]
fn roots_of_what_has_none_are_zero() {
    for x in [0.0, -0.0, -1.0, f32::NAN, f32::NEG_INFINITY, 1e-40] {
        assert_eq!(<f32 as Scalar>::sqrt(x), 0.0, "sqrt({x})");
        assert_eq!(<f64 as Scalar>::sqrt(f64::from(x).min(0.0)), 0.0);
    }
    assert_eq!(<f32 as Scalar>::sqrt(f32::INFINITY), f32::INFINITY);
    assert_eq!(Fixed::sqrt(wide(Fixed::new(-2.0))), Fixed::ZERO);
}

#[test]
fn the_root_of_a_fixed_point_number_is_right_to_a_step() {
    worst_error(STEP + 2048.0 * 1e-8, steps().map(|x| Fixed::sqrt(x.mul_wide(x)).to_f64() - x.to_f64()));
    worst_error(STEP, steps().map(|x| Fixed::sqrt(wide(x)).to_f64() - x.to_f64().sqrt()));
}

#[test]
fn fixed_point_division_is_right_to_a_step() {
    let pairs = steps().step_by(7).flat_map(|n| steps().step_by(41).map(move |d| (n, d)));
    worst_error(
        1.0,
        pairs.filter(|(n, d)| n.to_f64() / d.to_f64() < 2047.0).map(|(n, d)| {
            let negative = Fixed::div(wide(-n), wide(d));
            let positive = Fixed::div(wide(n), wide(d));
            assert_eq!(-negative, positive);
            let exact = n.to_f64() / d.to_f64();
            (positive.to_f64() - exact) / (STEP + 1e-8 * exact)
        }),
    );
}

#[test]
fn fixed_point_division_of_wide_values_is_right_and_saturates() {
    let large = Fixed::new(1800.0);
    let square = large.mul_wide(large);
    assert_eq!(Fixed::div(square, square), Fixed::ONE);
    assert_eq!(Fixed::div(-square, square + square), Fixed::new(-0.5));
    let least = Fixed::STEP.mul_wide(Fixed::STEP);
    assert_eq!(Fixed::div(least, square), Fixed::ZERO);
    assert_eq!(Fixed::div(square, least), Fixed::MAX);
    assert_eq!(Fixed::div(-square, least), -Fixed::MAX);
    assert_eq!(Fixed::div(FixedWide::ZERO, square), Fixed::ZERO);
    assert_eq!(Fixed::div(square, FixedWide::ZERO), Fixed::MAX);
    let limit = wide(Fixed::new(2047.5));
    let back = Fixed::div(limit, wide(Fixed::ONE)).to_f64();
    assert!((back - 2047.5).abs() <= STEP + 2048.0 * 1e-8);
    assert_eq!(Fixed::div(limit + wide(Fixed::ONE), wide(Fixed::ONE)), Fixed::MAX);
}

#[test]
fn reciprocals_are_right_to_a_step() {
    let usable = steps().filter(|x| x.to_f64() > 1.0 / 2047.0);
    let bound = |x: f64| STEP + 1e-8 / x;
    worst_error(1.0, usable.map(|x| (x.recip().to_f64() - 1.0 / x.to_f64()) / bound(x.to_f64())));
    assert_eq!(Fixed::new(-4.0).recip(), Fixed::new(-0.25));
    assert_eq!(Fixed::ZERO.recip(), Fixed::MAX);
}

#[test]
fn fixed_point_products_are_right_to_a_step_and_saturate() {
    let pairs = steps().step_by(13).flat_map(|a| steps().step_by(29).map(move |b| (a, b)));
    worst_error(
        STEP,
        pairs
            .filter(|(a, b)| a.to_f64() * b.to_f64() < 2047.0)
            .map(|(a, b)| (a * b).to_f64() - a.to_f64() * b.to_f64()),
    );
    let large = Fixed::new(1500.0);
    assert_eq!(large * large, Fixed::MAX);
    assert_eq!(large * -large, Fixed::MIN);
    assert_eq!(large + large, Fixed::MAX);
    assert_eq!(-large - large, Fixed::MIN);
    assert_eq!(-Fixed::MIN, Fixed::MAX);
}

#[test]
fn wide_fractions_of_fixed_point_numbers_are_exact() {
    let third = wide(Fixed::ONE).scale(1, 3);
    assert!((Fixed::narrow(third).to_f64() - 1.0 / 3.0).abs() <= STEP / 2.0);
    assert_eq!(Fixed::narrow(third + third + third), Fixed::ONE);
    // 900 * 15999 / 16000: the product alone would not fit.
    let edge = Fixed::narrow(wide(Fixed::new(900.0)).scale(15_999, 16_000)).to_f64();
    assert!((edge - 900.0 * 15_999.0 / 16_000.0).abs() <= STEP);
    let negative = Fixed::narrow(wide(Fixed::new(-900.0)).scale(15_999, 16_000)).to_f64();
    assert!((negative + edge).abs() <= STEP);
}

#[test]
fn floors_go_down_on_both_sides_of_zero() {
    for (x, floor) in [(1.5, 1), (-1.5, -2), (-1.0, -1), (0.0, 0), (-0.001, -1)] {
        assert_eq!(<f32 as Scalar>::floor(x as f32), floor);
        assert_eq!(<f64 as Scalar>::floor(x), floor);
        assert_eq!(Fixed::floor(wide(Fixed::new(x))), floor);
    }
    assert_eq!(<f32 as Scalar>::floor(-1e30), i32::MIN);
    assert_eq!(<f32 as Scalar>::floor(f32::NAN), 0);
    // Beyond the range of the plain number, where a chessboard may still have tiles.
    assert_eq!(Fixed::floor(Fixed::new(1000.5).mul_wide(Fixed::new(10.0))), 10_005);
}

#[test]
fn light_of_all_numbers_becomes_the_same_integers() {
    for light in [0.0, 0.25, 0.5, 0.999, 1.0, 7.0, -3.0] {
        let bits = light.light_bits();
        assert!((light as f32).light_bits().abs_diff(bits) <= 1);
        assert!(Fixed::new(light).light_bits().abs_diff(bits) <= 16);
    }
    assert_eq!(1.0_f64.light_bits(), 1 << 24);
    assert_eq!(f32::NAN.light_bits(), 0);
}

#[test]
fn a_fraction_is_what_lies_above_the_whole_number_below_and_never_reaches_one() {
    for x in [0.0, 0.25, 3.75, -0.25, -3.0, -1023.5] {
        let exact = x - f64::floor(x);
        assert_eq!(f64::from(<f32 as Scalar>::fract(x as f32)), exact);
        assert_eq!(Fixed::fract(wide(Fixed::new(x))).to_f64(), exact);
        assert_eq!(<f64 as Scalar>::fract(x), exact);
    }
    assert_eq!(<f32 as Scalar>::fract(-1e-12), <f32 as Scalar>::BELOW_ONE);
    assert!(<f32 as Scalar>::fract(1e18) < 1.0);
}

#[test]
fn light_goes_to_bits_and_back() {
    for bits in [0, 1 << 4, 12_345 << 4, 1 << 24] {
        assert_eq!(<f32 as Scalar>::from_light_bits(bits).light_bits(), bits);
        assert_eq!(Fixed::from_light_bits(bits).light_bits(), bits);
        assert_eq!(<f64 as Scalar>::from_light_bits(bits).light_bits(), bits);
    }
}
