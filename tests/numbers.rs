//! The number types keep the error bounds their documentation states, on both sides.

use scanray::math::{FixedWide, Scalar, Wide, tan_half, turns};
use scanray::{Fixed, Vec3};

const STEP: f64 = 1.0 / 1_048_576.0;

/// Runs over values and demands that the worst error reaches the bound's neighbourhood but never
/// passes it: a bound twenty times too wide fails as well.
fn worst_error(bound: f64, errors: impl Iterator<Item = f64>) {
    let worst = errors.fold(0.0, |worst: f64, error| {
        assert!(error.is_finite());
        worst.max(error.abs())
    });
    assert!(worst <= bound, "worst error {worst:e} passes the bound {bound:e}");
    assert!(worst >= bound / 20.0, "worst error {worst:e}: the bound {bound:e} says too little");
}

/// Positive floats of every magnitude from 2^-120 to 2^120, 4096 to a doubling.
fn floats() -> impl Iterator<Item = f32> {
    (7_u32..247).flat_map(|e| (0..1 << 23).step_by(2039).map(move |m| f32::from_bits(e << 23 | m)))
}

/// Fixed-point values from one step to the end of the range, ever coarser.
fn steps() -> impl Iterator<Item = Fixed> {
    (0..31_u32)
        .flat_map(|bits| (0..512_u64).map(move |m| (1_u64 << bits) + ((m << bits) >> 9)))
        .map(|steps| Fixed::new(steps as f64 * STEP))
}

fn wide(value: Fixed) -> FixedWide {
    value.mul_wide(Fixed::ONE)
}

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
fn sums_of_wide_products_saturate_instead_of_wrapping() {
    let corner = Vec3::new(Fixed::MAX, Fixed::MAX, Fixed::MAX);
    assert_eq!(corner.dot(corner), Fixed::MAX);
    assert_eq!(corner.dot(-corner), Fixed::MIN);
    assert!(corner.dot_wide(corner) > FixedWide::ZERO);
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

fn directions() -> impl Iterator<Item = [f64; 3]> {
    let axis = || (-7..=7).map(|i| f64::from(i) * 0.137 + 0.0113);
    axis().flat_map(move |x| axis().flat_map(move |y| axis().map(move |z| [x, y, z])))
}

fn unit_error<S: Scalar>(v: [f64; 3], make: fn(f64) -> S, read: fn(S) -> f64) -> f64 {
    let made = v.map(make);
    let back = made.map(read);
    let length = back.iter().map(|c| c * c).sum::<f64>().sqrt();
    let (unit, measured) = S::normalize(made).expect("none of the vectors is zero");
    let relative = (read(measured) - length).abs() / length.max(1.0);
    let components = unit.into_iter().zip(back).map(|(u, c)| (read(u) - c / length).abs());
    components.fold(relative, f64::max)
}

#[test]
fn unit_vectors_are_right_on_both_sides_from_short_to_long() {
    let scaled = |scale: f64| directions().map(move |v| v.map(|c| c * scale));
    for scale in [1e-3, 1.0, 600.0] {
        worst_error(2.0 * STEP, scaled(scale).map(|v| unit_error(v, Fixed::new, Fixed::to_f64)));
    }
    for scale in [1e-9, 1.0, 1e9] {
        worst_error(4e-7, scaled(scale).map(|v| unit_error(v, |c| c as f32, f64::from)));
        worst_error(1e-15, scaled(scale).map(|v| unit_error(v, |c| c, |c| c)));
    }
}

/// Answers the errors of products of two vectors and of a reflection, in units of `unit(a, b)`.
fn product_errors<S: Scalar>(
    [a, b]: [[f64; 3]; 2],
    make: fn(f64) -> S,
    read: fn(S) -> f64,
    unit: fn(f64) -> f64,
) -> [f64; 4] {
    let length = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let [p, q] = [a, b].map(|v| Vec3::from_array(v.map(make)));
    let [a, b] = [p, q].map(|v| v.to_array().map(read));
    let (normal, _) = q.normalize().expect("not zero");
    let n = normal.to_array().map(read);
    let e = unit(length(a) * length(b));
    let cross = a[1] * b[2] - a[2] * b[1];
    let mirrored = a[0] - 2.0 * dot(a, n) * n[0];
    [
        (read(p.dot(q)) - dot(a, b)) / (3.0 * e),
        (read(p.cross(q).x) - cross) / (3.0 * e),
        (read(p.reflect(normal).x) - mirrored) / (12.0 * unit(length(a))),
        (read(p.length()) - length(a)) / (length(a) * 4e-7 + 2.0 * unit(0.0)),
    ]
}

#[test]
fn products_of_vectors_are_right_on_both_sides() {
    let pairs = || directions().step_by(7).zip(directions().skip(5).step_by(5)).map(|(a, b)| [a, b]);
    for which in 0..4 {
        worst_error(
            1.0,
            pairs().map(|p| product_errors(p, Fixed::new, Fixed::to_f64, |_| STEP / 2.0)[which]),
        );
        worst_error(
            1.0,
            pairs().map(|p| product_errors(p, |x| x as f32, f64::from, |size| size * 6e-8)[which]),
        );
    }
}

#[test]
fn a_vector_of_no_length_has_no_direction() {
    assert!(Vec3::new(0.0_f32, 0.0, 0.0).normalize().is_none());
    assert!(Vec3::new(f32::NAN, 0.0, 0.0).normalize().is_none());
    assert!(Vec3::<Fixed>::ZERO.normalize().is_none());
    assert!(Vec3::new(Fixed::MIN, Fixed::MIN, Fixed::MIN).normalize().is_some());
}

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
fn nearly_known_lengths_are_brought_to_unit_length() {
    let vectors = || directions().flat_map(|v| [-1e-3, -2e-4, 0.0, 1e-5, 3e-4, 0.5].map(|off| (v, off)));
    let off = |(v, off): ([f64; 3], f64)| {
        let (unit, length) =
            Vec3::from_array(v).normalize_near(Vec3::from_array(v).length() * (1.0 + off))?;
        let exact = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        Some((unit.length() - 1.0).abs().max((length / exact - 1.0).abs()))
    };
    assert!(vectors().filter_map(off).all(|off| off < 1e-14));
    let short = |v: [f64; 3]| Vec3::from_array(v.map(|c| c as f32)).normalize();
    let off = |(unit, _): (Vec3<f32>, f32)| {
        let stretched = (unit * 1.0003).straighten().to_array().map(f64::from);
        stretched.iter().map(|c| c * c).sum::<f64>().sqrt() - 1.0
    };
    worst_error(4e-7, directions().filter_map(short).map(off));
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
