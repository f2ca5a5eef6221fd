//! Powers, exponentials and angles keep the error bounds their documentation states, on both sides.

use crate::bounds::{STEP, worst_error};
use scanray::Fixed;
use scanray::math::{Scalar, tan_half, turns};

#[test]
fn powers_of_cosines_are_right() {
    let bases = || (0..=1000).map(|i| f64::from(i) / 1000.0);
    for exponent in [0_u16, 1, 2, 10, 32, 142, 1000] {
        let exact = |x: f64| x.powi(i32::from(exponent));
        for x in bases() {
            let float = (x as f32).pow_unit(exponent);
            let bound = f64::from(exponent) * 6e-8 + 1e-7;
            let value = exact(f64::from(x as f32));
            let double = (x.pow_unit(exponent) - exact(x)).abs();
            assert!(double <= f64::from(exponent) * 2e-16 * exact(x) + 1e-300, "{x}^{exponent} in f64");
            assert!((f64::from(float) - value).abs() <= bound * value + 1e-30, "{x}^{exponent}");
            let base = Fixed::new(x);
            let fixed = base.pow_unit(exponent).to_f64() - exact(base.to_f64());
            assert!(fixed.abs() <= 2.0 * STEP, "{x}^{exponent}: off by {} steps", fixed / STEP);
        }
    }
    assert_eq!(Fixed::new(-0.5).pow_unit(2), Fixed::ZERO);
    assert_eq!(Fixed::new(3.0).pow_unit(2), Fixed::ONE);
}

#[test]
fn squares_in_fixed_point_are_rounded_to_the_nearest_step() {
    for step in (0..1_u32 << 20).step_by(97) {
        let x = f64::from(step) * STEP;
        let square = Fixed::new(x).pow_unit(2).to_f64() / STEP;
        assert_eq!(square, (x * x / STEP).round(), "({step} steps)^2");
    }
}

#[test]
fn falling_exponentials_are_right_from_1_to_nothing() {
    let ways = || (0..60_000).map(|i| f64::from(i) / 2000.0);
    let off = |x: f32| f64::from(x.exp_neg()) / (-f64::from(x)).exp() - 1.0;
    worst_error(2e-7 + 30.0 * 1e-7, ways().map(|x| off(x as f32)));
    worst_error(2e-13, ways().map(|x| x.exp_neg() / (-x).exp() - 1.0));
    let fixed = |x: f64| Fixed::new(x).exp_neg().to_f64() - (-Fixed::new(x).to_f64()).exp();
    worst_error(3.0 * STEP, ways().map(fixed));
    assert_eq!((1e30_f32.exp_neg(), f64::INFINITY.exp_neg(), Fixed::MAX.exp_neg()), (0.0, 0.0, Fixed::ZERO));
    assert_eq!(((-3.0_f32).exp_neg(), Fixed::MIN.exp_neg()), (1.0, Fixed::ONE));
    assert_eq!(f32::NAN.exp_neg(), 0.0);
}

#[test]
fn tangents_of_half_angles_are_right() {
    let angles = || (1..=1200).map(|i| f64::from(i) / 10.0);
    let exact = |degrees: f64| (degrees.to_radians() / 2.0).tan();
    worst_error(1e-6, angles().map(|a| f64::from(tan_half(a as f32)) / exact(f64::from(a as f32)) - 1.0));
    worst_error(2e-15, angles().map(|a| tan_half(a) / exact(a) - 1.0));
    let fixed = |a: f64| tan_half(Fixed::new(a)).to_f64() - exact(Fixed::new(a).to_f64());
    worst_error(2e-5, angles().map(fixed));
}

/// Answers the largest difference of angles from those of the standard library, all round the circle.
fn errors_of_turns<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) -> impl Iterator<Item = f64> {
    (0..200_000).map(move |i| {
        let angle = (f64::from(i) + 0.5) / 200_000.0;
        let (y, x) = (angle * std::f64::consts::TAU).sin_cos();
        let (y, x) = (make(y), make(x));
        let exact = read(y).atan2(read(x)) / std::f64::consts::TAU;
        read(turns(y, x)) - exact.rem_euclid(1.0)
    })
}

#[test]
fn angles_are_right_all_round_the_circle() {
    worst_error(3e-6, errors_of_turns(Fixed::new, Fixed::to_f64));
    worst_error(2e-7, errors_of_turns(|x| x as f32, f64::from));
    worst_error(4e-16, errors_of_turns(|x| x, |x| x));
}

#[test]
fn the_angles_of_the_axes_are_quarters_in_every_number() {
    fn check<S: Scalar>() {
        let quarter = S::HALF * S::HALF;
        let (zero, one) = (S::ZERO, S::ONE);
        let axes = [(zero, one), (one, zero), (zero, -one), (-one, zero), (one, one), (zero, zero)];
        let eighth = quarter * S::HALF;
        let expected = [zero, quarter, S::HALF, S::HALF + quarter, eighth, zero];
        assert_eq!(axes.map(|(y, x)| turns(y, x)), expected);
    }
    check::<f32>();
    check::<Fixed>();
    check::<f64>();
}
