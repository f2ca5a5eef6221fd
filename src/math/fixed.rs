//! [`Fixed`]: 12 bits before the point, 20 behind it, for chips without a floating-point unit.
//!
//! 20 bits behind the point make a step of 1e-6: a ray of unit length that is half a step off
//! lands 5e-4 off at a distance of 1000. 12 bits before it reach 2048.

use super::reciprocal::reciprocal;
use super::root;
use super::scalar::{Scalar, Wide};
use super::vec3::Vec3;
use core::ops::{Add, Mul, Neg, Sub};
use fixed::types::{I12F20, I24F40};

const FRACTION_BITS: u32 = 20;

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

/// Is a product of two [`Fixed`], or a sum of such products: 24 bits before the point, 40 behind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct FixedWide(I24F40);

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
        Self(I12F20::from_bits(rounded as i32))
    }

    /// Converts exactly.
    pub fn to_f64(self) -> f64 {
        f64::from(self.0.to_bits()) / f64::from(1_u32 << FRACTION_BITS)
    }

    fn bits(self) -> i32 {
        self.0.to_bits()
    }

    /// Takes a magnitude in steps and a sign; saturates.
    fn from_magnitude(steps: u64, negative: bool) -> Self {
        let steps = i32::try_from(steps).unwrap_or(i32::MAX);
        Self(I12F20::from_bits(if negative { -steps } else { steps }))
    }
}

impl Add for Fixed {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self(self.0.saturating_add(rhs.0))
    }
}

impl Sub for Fixed {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Self(self.0.saturating_sub(rhs.0))
    }
}

impl Mul for Fixed {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        Self(self.0.saturating_mul(rhs.0))
    }
}

impl Neg for Fixed {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.saturating_neg())
    }
}

impl Add for FixedWide {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self(self.0.saturating_add(rhs.0))
    }
}

impl Sub for FixedWide {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Self(self.0.saturating_sub(rhs.0))
    }
}

impl Neg for FixedWide {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.saturating_neg())
    }
}

impl Wide for FixedWide {
    const ZERO: Self = Self(I24F40::ZERO);

    fn scale(self, numerator: i32, denominator: i32) -> Self {
        // Quotient and remainder apart: their product with the numerator is rounded down once.
        let (bits, numerator, divisor) =
            (self.0.to_bits(), i64::from(numerator), i64::from(denominator.max(1)));
        let whole = bits.div_euclid(divisor).saturating_mul(numerator);
        let part = (bits.rem_euclid(divisor) * numerator).div_euclid(divisor);
        Self(I24F40::from_bits(whole.saturating_add(part)))
    }
}

/// Answers n / d in steps, rounded, within half a step + 4e-9 relative; too much for `Fixed` where
/// it is 2048 or more.
fn quotient(n: u64, d: u64) -> u64 {
    if d == 0 {
        return u64::MAX;
    }
    // Both as 32 significant bits and a shift.
    let (up, down) = (n.leading_zeros(), d.leading_zeros());
    let [m, divisor] = [(n << (up & 63)) >> 32, (d << down) >> 32];
    let product = m * u64::from(reciprocal(divisor as u32));
    // n / d = m / divisor * 2^(down - up), and the product is m / divisor * 2^62.
    let shift = (62 - FRACTION_BITS + up).saturating_sub(down);
    match shift {
        0..30 => u64::MAX,
        30..64 => (product + ((1 << shift) >> 1)) >> shift,
        _ => 0,
    }
}

/// Scalar of the chips without a floating-point unit; one step is 2^-20.
///
/// Error bounds: products one step, sums none, [`Scalar::sqrt`] one step + 4e-9 relative,
/// [`Scalar::div`] and [`Scalar::recip`] one step + 4e-9 relative, [`Scalar::normalize`] one step a component and
/// one step + 4e-9 relative for the length, [`Scalar::narrow`] half a step,
/// [`Scalar::pow_unit`] two steps beyond the error of its argument.
impl Scalar for Fixed {
    type Wide = FixedWide;

    const ZERO: Self = Self(I12F20::ZERO);
    const ONE: Self = Self(I12F20::ONE);
    const HALF: Self = Self::new(0.5);
    const BELOW_ONE: Self = Self(I12F20::from_bits((1 << FRACTION_BITS) - 1));
    const PARALLEL: Self = Self::new(1.0 / 65_536.0);
    const PI: Self = Self::new(core::f64::consts::PI);
    const FAR: Self = Self::MAX;
    const FAR_BACK: Self = Self::MIN;
    const SLACK: Self = Self::new(1.0 / 8192.0);
    const FADED: Self = Self::new(0.7 * FRACTION_BITS as f64);
    // The difference of two such coordinates still fits; a length may not, and counts as FAR.
    const LIMIT: Self = Self::new(1024.0);
    const SKIN: Self = Self::new(1.0 / 1024.0);

    fn from_i32(n: i32) -> Self {
        Self(I12F20::saturating_from_num(n))
    }

    fn mul_wide(self, rhs: Self) -> FixedWide {
        FixedWide(self.0.wide_mul(rhs.0))
    }

    fn narrow(wide: FixedWide) -> Self {
        let steps = wide.0.to_bits().saturating_add(1 << (FRACTION_BITS - 1)) >> FRACTION_BITS;
        Self(I12F20::from_bits(steps.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32))
    }

    fn sqrt(wide: FixedWide) -> Self {
        let square = u64::try_from(wide.0.to_bits()).unwrap_or(0);
        Self::from_magnitude(root::sqrt(square), false)
    }

    fn div(numerator: FixedWide, denominator: FixedWide) -> Self {
        let (n, d) = (numerator.0.to_bits(), denominator.0.to_bits());
        Self::from_magnitude(quotient(n.unsigned_abs(), d.unsigned_abs()), (n < 0) != (d < 0))
    }

    fn recip(self) -> Self {
        let size = u64::from(self.bits().unsigned_abs());
        Self::from_magnitude(quotient(1 << FRACTION_BITS, size), self.bits() < 0)
    }

    fn floor(wide: FixedWide) -> i32 {
        (wide.0.to_bits() >> (2 * FRACTION_BITS)) as i32
    }

    fn pow_unit(self, exponent: u16) -> Self {
        // Fractions of 2^31, so that squaring again and again loses nothing of the 20 places.
        const ONE: u64 = 1 << 31;
        let multiply = |a: u64, b: u64| (a * b + (ONE >> 1)) >> 31;
        let mut base = (self.bits().clamp(0, 1 << FRACTION_BITS) as u64) << 11;
        let (mut left, mut product) = (exponent, ONE);
        while left > 0 {
            if left & 1 == 1 {
                product = multiply(product, base);
            }
            base = multiply(base, base);
            left >>= 1;
        }
        Self::from_magnitude((product + (1 << 10)) >> 11, false)
    }

    fn normalize(v: [Self; 3]) -> Option<([Self; 3], Self)> {
        let [x, y, z] = v.map(|c| i64::from(c.bits()));
        let largest = x.unsigned_abs().max(y.unsigned_abs()).max(z.unsigned_abs());
        if largest == 0 {
            return None;
        }
        // Lift the largest component to at least 2^30, so that short vectors keep their digits.
        let lift = largest.leading_zeros().saturating_sub(33);
        let (x, y, z) = (x << lift, y << lift, z << lift);
        let square = (x * x) as u64 + (y * y) as u64 + (z * z) as u64;
        let even = square.leading_zeros() & !1;
        let m = ((square << even) >> 32) as u32;
        let reciprocal = root::rsqrt(m);
        // Component * 2^20 / length, where 1 / length = reciprocal / 2^(62 - even / 2).
        let down = 42 - even / 2;
        let unit = |c: i64| {
            let steps = (c * i64::from(reciprocal) + (1 << (down - 1))) >> down;
            Self(I12F20::from_bits(steps as i32))
        };
        let length = ((u64::from(m) * u64::from(reciprocal)) >> 30) >> (even / 2);
        Some(([unit(x), unit(y), unit(z)], Self::from_magnitude(length >> lift, false)))
    }

    fn light_bits(self) -> u32 {
        (self.bits().clamp(0, (1 << 27) - 1) as u32) << 4
    }

    fn in_range(self) -> bool {
        Scalar::abs(self) <= Self::LIMIT
    }
}
