//! `f64`: for hosts, to measure what the numbers of the devices round away.

use super::scalar::{Scalar, Wide};

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

impl Wide for f64 {
    const ZERO: Self = 0.0;

    fn scale(self, numerator: i32, denominator: i32) -> Self {
        self * f64::from(numerator) / f64::from(denominator.max(1))
    }
}

/// Scalar of the host's measurements. Error bound of every function: 1e-15 relative.
impl Scalar for f64 {
    type Wide = f64;

    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const HALF: Self = 0.5;
    const PI: Self = core::f64::consts::PI;
    const FAR: Self = 1e18;
    const LIMIT: Self = 1e16;
    const SKIN: Self = 1e-9;

    fn from_i32(n: i32) -> Self {
        f64::from(n)
    }

    fn mul_wide(self, rhs: Self) -> f64 {
        self * rhs
    }

    fn narrow(wide: f64) -> Self {
        wide
    }

    fn sqrt(wide: f64) -> Self {
        if wide >= f64::MIN_POSITIVE {
            if wide > f64::MAX {
                return wide;
            }
            wide * rsqrt(wide)
        } else {
            0.0
        }
    }

    fn div(numerator: f64, denominator: f64) -> Self {
        if denominator == 0.0 {
            return if numerator < 0.0 { -f64::MAX } else { f64::MAX };
        }
        numerator / denominator
    }

    fn recip(self) -> Self {
        Self::div(1.0, self)
    }

    fn floor(self) -> i32 {
        let whole = self as i32;
        if f64::from(whole) > self { whole.saturating_sub(1) } else { whole }
    }

    fn pow_unit(self, exponent: u16) -> Self {
        let (mut base, mut left, mut product) = (Scalar::max(self, 0.0), exponent, 1.0);
        while left > 0 {
            if left & 1 == 1 {
                product *= base;
            }
            base *= base;
            left >>= 1;
        }
        product
    }

    fn normalize([x, y, z]: [Self; 3]) -> Option<([Self; 3], Self)> {
        let square = x * x + y * y + z * z;
        if !(1e-60..=f64::MAX).contains(&square) {
            return None;
        }
        let r = rsqrt(square);
        Some(([x * r, y * r, z * r], square * r))
    }

    fn light_bits(self) -> u32 {
        ((self * 16_777_216.0) as u32).min(1 << 24)
    }

    fn in_range(self) -> bool {
        Scalar::abs(self) <= Self::LIMIT
    }
}
