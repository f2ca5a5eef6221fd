//! `f64`: for hosts, to measure what the numbers of the devices round away.

use super::float::float_scalar;

/// Answers 1/sqrt(x) within 4e-16 relative, for normal positive x.
///
/// The seed is the exponent halved by a shift (Lomont 2003, 3.4 % off); each Newton step squares
/// the error, and the fifth has nothing left to gain.
fn rsqrt(x: f64) -> f64 {
    let mut y = f64::from_bits(0x5FE6_EB50_C7B5_37A9 - (x.to_bits() >> 1));
    for _ in 0..5 {
        y = y * (1.5 - 0.5 * x * y * y);
    }
    y
}

float_scalar! {
    /// Scalar of the host's measurements.
    ///
    /// Error bounds, relative: roots and unit vectors 1e-15, [`Scalar::pow_unit`](super::Scalar::pow_unit)
    /// `exponent` * 2e-16; `recip` and `div` are correctly rounded.
    f64, skin: 1e-9, shortest_square: 1e-60, pi: core::f64::consts::PI, arctangent_terms: 11
}
