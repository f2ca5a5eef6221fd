//! Vectors keep the error bounds of their numbers, on both sides.

use crate::bounds::{STEP, worst_error};
use scanray::math::{FixedWide, Scalar, Wide};
use scanray::{Fixed, Vec3};

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
fn sums_of_wide_products_saturate_instead_of_wrapping() {
    let corner = Vec3::new(Fixed::MAX, Fixed::MAX, Fixed::MAX);
    assert_eq!(corner.dot(corner), Fixed::MAX);
    assert_eq!(corner.dot(-corner), Fixed::MIN);
    assert!(corner.dot_wide(corner) > FixedWide::ZERO);
}

#[test]
fn a_vector_of_no_length_has_no_direction() {
    assert!(Vec3::new(0.0_f32, 0.0, 0.0).normalize().is_none());
    assert!(Vec3::new(f32::NAN, 0.0, 0.0).normalize().is_none());
    assert!(Vec3::<Fixed>::ZERO.normalize().is_none());
    assert!(Vec3::new(Fixed::MIN, Fixed::MIN, Fixed::MIN).normalize().is_some());
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
