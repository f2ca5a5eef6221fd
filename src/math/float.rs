//! `f32`: for chips with a floating-point unit.
//!
//! The square root starts from a line through the bits (C. Lomont 2003; 3.4 % off) and takes three Newton steps, which
//! leaves 3e-7. Only `+ - * /` and casts are used, so the bits are the same on every chip.

/// Answers 1/sqrt(x) within 3e-7 relative, for normal positive x.
fn rsqrt(x: f32) -> f32 {
    let half = 0.5 * x;
    // The difference wraps for what is not positive.
    let mut y = f32::from_bits(0x5f37_5a86_u32.wrapping_sub(x.to_bits() >> 1));
    for _ in 0..3 {
        y = y * (1.5 - half * y * y);
    }
    y
}

/// Implements the number traits for a float, by the `rsqrt` in scope.
macro_rules! float_scalar {
    (
        $(#[$about:meta])* $float:ty,
        skin: $skin:expr,
        shortest_square: $shortest:expr,
        pi: $pi:expr,
        arctangent_terms: $terms:expr
    ) => {
        impl $crate::math::Wide for $float {
            const ZERO: Self = 0.0;

            fn scale(self, numerator: i32, denominator: i32) -> Self {
                self * (numerator as $float) / (denominator.max(1) as $float)
            }
        }

        $(#[$about])*
        impl $crate::math::Scalar for $float {
            type Wide = $float;

            const EXACT_PRODUCTS: bool = false;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const HALF: Self = 0.5;
            const BELOW_ONE: Self = 1.0 - <$float>::EPSILON / 2.0;
            const PARALLEL: Self = 1.0 / 65_536.0;
            const PI: Self = $pi;
            const FAR: Self = 1e18;
            const FAR_BACK: Self = -1e18;
            const SLACK: Self = 1.0 / 8192.0;
            // ln 2 is 0.693.
            const FADED: Self = 0.7 * <$float>::MANTISSA_DIGITS as $float;
            // Three squares of a difference of two such coordinates are 1.2e33, and f32 ends at 3.4e38.
            const LIMIT: Self = 1e16;
            const SKIN: Self = $skin;
            const ARCTANGENT: $crate::math::Arctangent<Self> = $crate::math::Arctangent {
                sixteenth: (core::f64::consts::SQRT_2 - 1.0) as $float,
                series: &{
                    let exact = $crate::math::azimuth::series::<$terms>();
                    let mut rounded = [0.0; $terms];
                    let mut k = 0;
                    while k < $terms {
                        rounded[k] = exact[k] as $float;
                        k += 1;
                    }
                    rounded
                },
            };

            fn from_i32(n: i32) -> Self {
                n as $float
            }

            fn mul_wide(self, rhs: Self) -> $float {
                self * rhs
            }

            fn narrow(wide: $float) -> Self {
                wide
            }

            /// Below the least normal number, and for what is not a number, the answer is 0.
            fn sqrt(wide: $float) -> Self {
                // As in `normalize`, one comparison of bits finds what has an ordinary root.
                let (least, most) = (<$float>::MIN_POSITIVE.to_bits(), <$float>::MAX.to_bits());
                if wide.to_bits().wrapping_sub(least) <= most - least {
                    wide * rsqrt(wide)
                } else if wide > <$float>::MAX {
                    wide
                } else {
                    0.0
                }
            }

            fn div(numerator: $float, denominator: $float) -> Self {
                if denominator == 0.0 {
                    return if numerator < 0.0 { -<$float>::MAX } else { <$float>::MAX };
                }
                numerator / denominator
            }

            fn recip(self) -> Self {
                Self::div(1.0, self)
            }

            fn floor(wide: $float) -> i32 {
                let whole = wide as i32;
                if (whole as $float) > wide { whole.saturating_sub(1) } else { whole }
            }

            fn fract(wide: $float) -> Self {
                let above = wide - <Self as $crate::math::Scalar>::floor(wide) as $float;
                // Just below a whole number the difference rounds to 1; beyond 2^31 it is no fraction.
                $crate::math::Scalar::min($crate::math::Scalar::max(above, 0.0), Self::BELOW_ONE)
            }

            fn pow_unit(self, exponent: u16) -> Self {
                let (mut base, mut left, mut product) = ($crate::math::Scalar::max(self, 0.0), exponent, 1.0);
                while left > 0 {
                    if left & 1 == 1 {
                        product *= base;
                    }
                    base *= base;
                    left >>= 1;
                }
                product
            }

            fn exp_neg(self) -> Self {
                // Beyond 80 the answer is less than any light; what is not a number is taken as that.
                let x = $crate::math::Scalar::max($crate::math::Scalar::min(self, 80.0), 0.0);
                if x >= 80.0 {
                    return 0.0;
                }
                let halvings = (x * core::f64::consts::LOG2_E as $float) as u16;
                let rest = x - <$float>::from(halvings) * core::f64::consts::LN_2 as $float;
                // Taylor's series to the power 13 leaves ln 2^14 / 14! = 7e-14.
                let series = (1..14_u8).rev().fold(1.0, |sum, n| 1.0 - rest * sum / <$float>::from(n));
                series * $crate::math::Scalar::pow_unit(0.5, halvings)
            }

            fn normalize([x, y, z]: [Self; 3]) -> Option<([Self; 3], Self)> {
                let square = x * x + y * y + z * z;
                // Shorter ones would take the reciprocal root out of the range. Bits of positive
                // floats are in order, so that one comparison of integers looks at both ends.
                const SHORTEST: $float = $shortest;
                let above = square.to_bits().wrapping_sub(SHORTEST.to_bits());
                if above > <$float>::MAX.to_bits() - SHORTEST.to_bits() {
                    return None;
                }
                let r = rsqrt(square);
                Some(([x * r, y * r, z * r], square * r))
            }

            fn normalize_near([x, y, z]: [Self; 3], length: Self) -> Option<([Self; 3], Self)> {
                // A division is one instruction where there is a floating-point unit, `rsqrt` 17.
                let scale = 1.0 / length;
                let off = 1.0 - (x * x + y * y + z * z) * scale * scale;
                // 1 + off / 2 for 1 / sqrt(1 - off) leaves 3/8 of the square.
                if off * off <= <$float>::EPSILON {
                    let half = 0.5 * off;
                    let r = scale + scale * half;
                    Some(([x * r, y * r, z * r], length - length * half))
                } else {
                    Self::normalize([x, y, z])
                }
            }

            fn light_bits(self) -> u32 {
                // The cast takes what is not a number to 0 and saturates below.
                (self * 16_777_216.0) as u32
            }

            fn from_light_bits(bits: u32) -> Self {
                bits as $float * (1.0 / 16_777_216.0)
            }

            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            fn abs(self) -> Self {
                // One instruction where there is a floating-point unit; a comparison takes five.
                <$float>::abs(self)
            }

            fn next_up(self) -> Self {
                <$float>::next_up(self)
            }

            fn in_range(self) -> bool {
                $crate::math::Scalar::abs(self) <= Self::LIMIT
            }
        }
    };
}

pub(super) use float_scalar;

float_scalar! {
    /// Scalar of the chips with a floating-point unit.
    ///
    /// Error bounds, relative: [`Scalar::sqrt`](super::Scalar::sqrt) and
    /// [`Scalar::normalize`](super::Scalar::normalize) 4e-7,
    /// [`Scalar::pow_unit`](super::Scalar::pow_unit) `exponent` * 6e-8 + 1e-7; `recip` and `div` are
    /// correctly rounded; [`Scalar::exp_neg`](super::Scalar::exp_neg) 2e-7 + x * 1e-7.
    f32, skin: 1.0 / 1024.0, shortest_square: 1e-30, pi: core::f32::consts::PI, arctangent_terms: 5
}
