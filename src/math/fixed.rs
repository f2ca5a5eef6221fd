//! [`Fixed`]: 12 bits before the point, 20 behind it, for chips without a floating-point unit.
//!
//! 20 bits behind the point make a step of 1e-6: a ray of unit length that is half a step off
//! lands 5e-4 off at a distance of 1000. 12 bits before it reach 2048.

use super::azimuth::{Arctangent, series};
use super::scalar::Scalar;
use super::steps::{self, FRACTION_BITS};
use super::vec3::Vec3;
use super::wide::FixedWide;
use super::{power::power, quotient, root, unit::unit};
use core::ops::{Add, Mul, Neg, Sub};
use fixed::types::I12F20;

/// Is a fixed-point number whose operators saturate.
///
/// ```
/// use scanray::Fixed;
/// let three = Fixed::new(1.5) * Fixed::new(2.0);
/// assert_eq!(three.to_f64(), 3.0);
/// assert_eq!(Fixed::new(2000.0) + Fixed::new(2000.0), Fixed::MAX);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fixed(I12F20);

impl Vec3<Fixed> {
    /// Rounds three literals, at compile time for a constant.
    pub const fn from_f64(x: f64, y: f64, z: f64) -> Self {
        Self::new(Fixed::new(x), Fixed::new(y), Fixed::new(z))
    }
}

impl Fixed {
    /// Is the largest value, just below 2048; also what saturation answers.
    pub const MAX: Self = Self(I12F20::MAX);
    /// Is the smallest value, -2048.
    pub const MIN: Self = Self(I12F20::MIN);
    /// Is the step between two neighbouring values, 2^-20.
    pub const STEP: Self = Self(I12F20::DELTA);

    /// Rounds to the nearest value, at compile time for a constant. Saturates; NaN becomes 0.
    pub const fn new(value: f64) -> Self {
        let scaled = value * (1_u32 << FRACTION_BITS) as f64;
        let rounded = if scaled < 0.0 { scaled - 0.5 } else { scaled + 0.5 };
        Self::of(rounded as i32)
    }

    /// Converts exactly.
    pub fn to_f64(self) -> f64 {
        f64::from(self.bits()) / f64::from(1_u32 << FRACTION_BITS)
    }

    const fn of(steps: i32) -> Self {
        Self(I12F20::from_bits(steps))
    }

    const fn bits(self) -> i32 {
        self.0.to_bits()
    }

    /// Takes a magnitude in steps and a sign; saturates.
    fn from_magnitude(steps: u32, negative: bool) -> Self {
        let steps = steps.min(i32::MAX as u32) as i32;
        Self::of(if negative { -steps } else { steps })
    }
}

impl Add for Fixed {
    type Output = Self;
    #[inline]
    fn add(self, rhs: Self) -> Self {
        Self::of(steps::add(self.bits(), rhs.bits()))
    }
}

impl Sub for Fixed {
    type Output = Self;
    #[inline]
    fn sub(self, rhs: Self) -> Self {
        Self::of(steps::subtract(self.bits(), rhs.bits()))
    }
}

impl Mul for Fixed {
    type Output = Self;
    #[inline]
    fn mul(self, rhs: Self) -> Self {
        Self::of(steps::multiply(self.bits(), rhs.bits()))
    }
}

impl Neg for Fixed {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::of(self.bits().saturating_neg())
    }
}

/// Scalar of the chips without a floating-point unit; one step is 2^-20.
///
/// Error bounds: products one step, sums none, [`Scalar::sqrt`], [`Scalar::div`] and [`Scalar::recip`] one step +
/// 1e-8 relative, [`Scalar::normalize`] one step a component and one step + 1e-8 relative for the length,
/// [`Scalar::narrow`] half a step, [`Scalar::pow_unit`] two steps beyond the error of its argument up to an exponent
/// of 4096, [`Scalar::exp_neg`] three steps.
impl Scalar for Fixed {
    type Wide = FixedWide;

    const EXACT_PRODUCTS: bool = true;
    const ZERO: Self = Self(I12F20::ZERO);
    const ONE: Self = Self(I12F20::ONE);
    const HALF: Self = Self::new(0.5);
    const BELOW_ONE: Self = Self::of((1 << FRACTION_BITS) - 1);
    const PARALLEL: Self = Self::new(1.0 / 65_536.0);
    const PI: Self = Self::new(core::f64::consts::PI);
    const FAR: Self = Self::MAX;
    const FAR_BACK: Self = Self::MIN;
    const SLACK: Self = Self::new(1.0 / 8192.0);
    const FADED: Self = Self::new(0.7 * FRACTION_BITS as f64);
    // The difference of two such coordinates still fits; a length may not, and counts as FAR.
    const LIMIT: Self = Self::new(1024.0);
    const SKIN: Self = Self::new(1.0 / 1024.0);
    const ARCTANGENT: Arctangent<Self> = Arctangent {
        sixteenth: Self::new(core::f64::consts::SQRT_2 - 1.0),
        series: &{
            let [a, b, c, d] = series::<4>();
            [Self::new(a), Self::new(b), Self::new(c), Self::new(d)]
        },
    };

    fn from_i32(n: i32) -> Self {
        Self(I12F20::saturating_from_num(n))
    }

    #[inline]
    fn mul_wide(self, rhs: Self) -> FixedWide {
        FixedWide::of(steps::multiply_wide(self.bits(), rhs.bits()))
    }

    #[inline]
    fn narrow(wide: FixedWide) -> Self {
        Self::of(steps::narrow(wide.bits()))
    }

    #[inline]
    fn add_product(self, a: Self, b: Self) -> Self {
        Self::of(steps::add_product(self.bits(), a.bits(), b.bits()))
    }

    #[inline]
    fn determinant(first: [Self; 2], second: [Self; 2]) -> Self {
        Self::of(steps::determinant(first.map(Self::bits), second.map(Self::bits)))
    }

    #[inline]
    fn dot(a: [Self; 3], b: [Self; 3]) -> Self {
        Self::of(steps::dot(a.map(Self::bits), b.map(Self::bits)))
    }

    #[inline]
    fn dot_wide(a: [Self; 3], b: [Self; 3]) -> FixedWide {
        FixedWide::of(steps::dot_wide(a.map(Self::bits), b.map(Self::bits)))
    }

    fn sqrt(wide: FixedWide) -> Self {
        Self::of(root::sqrt(u64::try_from(wide.bits()).unwrap_or(0)))
    }

    fn div(numerator: FixedWide, denominator: FixedWide) -> Self {
        let (n, d) = (numerator.bits(), denominator.bits());
        Self::from_magnitude(quotient::quotient(n.unsigned_abs(), d.unsigned_abs()), (n ^ d) < 0)
    }

    fn ratio(self, divisor: Self) -> Self {
        let (n, d) = (self.bits(), divisor.bits());
        Self::from_magnitude(quotient::ratio(n.unsigned_abs(), d.unsigned_abs()), (n ^ d) < 0)
    }

    fn recip(self) -> Self {
        Self::from_magnitude(quotient::reciprocal(self.bits().unsigned_abs()), self.bits() < 0)
    }

    #[inline]
    fn floor(wide: FixedWide) -> i32 {
        (wide.bits() >> (2 * FRACTION_BITS)) as i32
    }

    #[inline]
    fn fract(wide: FixedWide) -> Self {
        Self::of((wide.bits() >> FRACTION_BITS) as i32 & ((1 << FRACTION_BITS) - 1))
    }

    fn pow_unit(self, exponent: u16) -> Self {
        if self >= Self::ONE || exponent == 0 {
            return Self::ONE;
        }
        // A fraction of 2^32, so that squaring again and again loses nothing of the 20 places.
        let fraction = (self.bits().max(0) as u32) << (32 - FRACTION_BITS);
        let rounded =
            power(fraction, exponent).wrapping_add(1 << (31 - FRACTION_BITS)) >> (32 - FRACTION_BITS);
        Self::of(rounded as i32)
    }

    fn exp_neg(self) -> Self {
        // Beyond it less than half a step is left.
        if self >= Self::new(14.6) {
            return Self::ZERO;
        }
        let powers = Scalar::max(self, Self::ZERO) * Self::new(core::f64::consts::LOG2_E);
        let halvings = powers.bits() >> FRACTION_BITS;
        let rest = (powers - Self::from_i32(halvings)) * Self::new(core::f64::consts::LN_2);
        // Taylor's series to the power 8 leaves ln 2^9 / 9! = 1e-7.
        const SHARES: [Fixed; 8] = {
            let mut shares = [Fixed::ONE; 8];
            let mut n = 0;
            while n < 8 {
                shares[n] = Fixed::new(1.0 / (n as f64 + 1.0));
                n += 1;
            }
            shares
        };
        let series = SHARES.iter().rev().fold(Self::ONE, |sum, share| Self::ONE - rest * sum * *share);
        Self::of((series.bits() << 1).wrapping_shr(halvings as u32).wrapping_add(1) >> 1)
    }

    #[inline(never)]
    fn normalize(v: [Self; 3]) -> Option<([Self; 3], Self)> {
        let (unit, length) = unit(v.map(Self::bits))?;
        Some((unit.map(Self::of), Self::of(length)))
    }

    fn light_bits(self) -> u32 {
        (self.bits().clamp(0, (1 << 27) - 1) as u32) << 4
    }

    fn to_f64(self) -> f64 {
        Self::to_f64(self)
    }

    fn from_light_bits(bits: u32) -> Self {
        Self::of((bits.min(1 << 24) >> 4) as i32)
    }

    fn next_up(self) -> Self {
        Self::of(self.bits().saturating_add(1))
    }

    fn in_range(self) -> bool {
        Scalar::abs(self) <= Self::LIMIT
    }
}
