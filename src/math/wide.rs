//! [`FixedWide`]: products of fixed-point numbers, and their sums.

use super::scalar::Wide;
use super::zeros::leading_zeros;
use core::hint::cold_path;
use core::ops::{Add, Neg, Sub};
use fixed::types::I24F40;

/// Is a product of two [`Fixed`](super::Fixed), or a sum of such products: 24 bits before the point, 40 behind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct FixedWide(I24F40);

impl FixedWide {
    pub(super) const fn of(bits: i64) -> Self {
        Self(I24F40::from_bits(bits))
    }

    pub(super) const fn bits(self) -> i64 {
        self.0.to_bits()
    }
}

/// Answers the largest number of the sign of `n`.
const fn saturated(n: i64) -> i64 {
    cold_path();
    i64::MAX ^ (n >> 63)
}

impl Add for FixedWide {
    type Output = Self;
    #[inline]
    fn add(self, rhs: Self) -> Self {
        let (a, b) = (self.bits(), rhs.bits());
        let sum = a.wrapping_add(b);
        // Only the sum of two of one sign has another sign wrongly, and the upper words tell: the standard library's
        // comparison of both words takes 18 instructions on an M0+.
        Self::of(if ((a ^ sum) & (b ^ sum)) >> 32 < 0 { saturated(a) } else { sum })
    }
}

impl Sub for FixedWide {
    type Output = Self;
    #[inline]
    fn sub(self, rhs: Self) -> Self {
        let (a, b) = (self.bits(), rhs.bits());
        let difference = a.wrapping_sub(b);
        Self::of(if ((a ^ b) & (a ^ difference)) >> 32 < 0 { saturated(a) } else { difference })
    }
}

impl Neg for FixedWide {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::ZERO - self
    }
}

impl Wide for FixedWide {
    const ZERO: Self = Self::of(0);

    /// Called, never inlined: 64-bit divisions and their operands were a third of an M0+'s image.
    #[inline(never)]
    fn scale(self, numerator: i32, denominator: i32) -> Self {
        if numerator == 1 && denominator > 0 && denominator & (denominator - 1) == 0 {
            return Self::of(
                self.bits().wrapping_shr(31_u32.wrapping_sub(leading_zeros(denominator as u32))),
            );
        }
        // Quotient and remainder apart: their product with the numerator is rounded down once.
        let (bits, divisor) = (self.bits(), i64::from(denominator.max(1)));
        let (quotient, remainder) = (bits.div_euclid(divisor), bits.rem_euclid(divisor));
        let whole = quotient.saturating_mul(i64::from(numerator));
        // Numbers as small as a panel's sides need no second division of 64 bits: 300 instructions less on an M0+.
        let small = u32::try_from(numerator).ok().and_then(|n| (remainder as u32).checked_mul(n));
        let part = match small {
            Some(product) => i64::from(product / divisor as u32),
            None => remainder.wrapping_mul(i64::from(numerator)).div_euclid(divisor),
        };
        Self::of(whole.saturating_add(part))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_and_differences_saturate_at_the_end_they_pass() {
        let ends = [i64::MIN, i64::MIN + 1, -(1 << 62), -(1 << 32), -1, 0, 1, 1 << 32, 1 << 62, i64::MAX];
        for (a, b) in ends.iter().flat_map(|a| ends.map(|b| (*a, b))) {
            let (p, q) = (FixedWide::of(a), FixedWide::of(b));
            assert_eq!((p + q).bits(), a.saturating_add(b), "{a} + {b}");
            assert_eq!((p - q).bits(), a.saturating_sub(b), "{a} - {b}");
            assert_eq!((-p).bits(), a.saturating_neg(), "-{a}");
        }
    }

    #[test]
    fn fractions_are_rounded_down_once() {
        let numbers = [0, 1, -1, 12_345_678_901_234, -12_345_678_901_234, 1 << 61, -(1 << 61)];
        for (n, d) in [(1, 3), (1, 65_536), (1, 1), (5, 7), (-5, 7), (639, 640), (1 << 20, 1_000_003), (2, 0)]
        {
            for bits in numbers {
                let exact = (i128::from(bits) * i128::from(n)).div_euclid(i128::from(d.max(1)));
                let fitting = exact.clamp(i64::MIN.into(), i64::MAX.into());
                assert_eq!(i128::from(FixedWide::of(bits).scale(n, d).bits()), fitting, "{bits} * {n} / {d}");
            }
        }
    }
}
