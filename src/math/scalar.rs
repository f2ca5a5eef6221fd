use super::azimuth::Arctangent;
use core::fmt::Debug;
use core::ops::{Add, Mul, Neg, Sub};

/// Is a number that rays can be traced in.
///
/// It asks only for what a float and a fixed-point number can both answer honestly: no
/// trigonometry and no general powers. Operators of fixed point saturate, those of floats go to
/// infinity; nothing wraps and nothing panics.
pub trait Scalar:
    Copy
    + PartialEq
    + PartialOrd
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + Sync
    + 'static
{
    /// Holds products of two scalars and their sums: in fixed point every digit, in floats as many
    /// as the float has.
    type Wide: Wide;

    /// Says whether [`Self::Wide`] holds every digit of a product, as it does in fixed point.
    const EXACT_PRODUCTS: bool;
    /// Is 0.
    const ZERO: Self;
    /// Is 1.
    const ONE: Self;
    /// Is 1/2.
    const HALF: Self;
    /// Is the largest value below 1.
    const BELOW_ONE: Self;
    /// Is the sine of the angle below which two directions count as parallel, 2^-16: ten times what
    /// rounding makes of parallel ones in the coarsest number.
    const PARALLEL: Self;
    /// Is the half circumference of the unit circle.
    const PI: Self;
    /// Stands for "infinitely far": no hit is looked for beyond this distance.
    const FAR: Self;
    /// Is as far as [`Self::FAR`], the other way.
    const FAR_BACK: Self;
    /// Is a share of a distance that outweighs the rounding of a ray, 2^-13: a hundred times it in
    /// the coarsest number.
    const SLACK: Self;
    /// Is the x from which exp(-x) is less than the number's step at 1.
    const FADED: Self;
    /// Is the largest magnitude a coordinate, radius or colour of a scene may have.
    const LIMIT: Self;
    /// Is how far a ray travels from a user's own shape before it may hit that shape again.
    const SKIN: Self;
    /// Holds what [`turns`](super::turns) finds angles by.
    const ARCTANGENT: Arctangent<Self>;

    /// Converts a small whole number; saturates.
    fn from_i32(n: i32) -> Self;
    /// Multiplies into the wide type, exactly where the number is fixed point.
    fn mul_wide(self, rhs: Self) -> Self::Wide;
    /// Brings a wide value back; saturates.
    fn narrow(wide: Self::Wide) -> Self;
    /// Answers `self + a b`.
    fn add_product(self, a: Self, b: Self) -> Self {
        self + a * b
    }
    /// Answers `a d - b c` of the rows `[a, b]` and `[c, d]`, rounded once in fixed point.
    fn determinant([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        Self::narrow(a.mul_wide(d) - b.mul_wide(c))
    }
    /// Answers the scalar product, rounded once in fixed point.
    fn dot(a: [Self; 3], b: [Self; 3]) -> Self {
        Self::narrow(Self::dot_wide(a, b))
    }
    /// Answers the scalar product as a wide value.
    fn dot_wide(a: [Self; 3], b: [Self; 3]) -> Self::Wide {
        a[0].mul_wide(b[0]) + a[1].mul_wide(b[1]) + a[2].mul_wide(b[2])
    }
    /// Takes the square root of a wide value; 0 for a negative one.
    fn sqrt(wide: Self::Wide) -> Self;
    /// Divides two wide values. A zero divisor answers the largest value of the quotient's sign.
    fn div(numerator: Self::Wide, denominator: Self::Wide) -> Self;
    /// Divides by another number, like [`Self::div`].
    fn ratio(self, divisor: Self) -> Self {
        Self::div(self.mul_wide(Self::ONE), divisor.mul_wide(Self::ONE))
    }
    /// Answers 1/self; for 0 the largest value.
    fn recip(self) -> Self;
    /// Rounds a wide value down to a whole number; saturates.
    fn floor(wide: Self::Wide) -> i32;
    /// Answers what a wide value is above the whole number below it, from 0 to below 1.
    fn fract(wide: Self::Wide) -> Self;
    /// Raises a value of [0, 1] to a whole power by repeated squaring.
    fn pow_unit(self, exponent: u16) -> Self;
    /// Answers exp(-self); 1 for what is below 0.
    fn exp_neg(self) -> Self;
    /// Scales a vector to unit length and answers it with the length it had; `None` for zero.
    fn normalize(v: [Self; 3]) -> Option<([Self; 3], Self)>;
    /// Scales a vector of about a known length, above 0, like [`Self::normalize`].
    fn normalize_near(v: [Self; 3], _length: Self) -> Option<([Self; 3], Self)> {
        Self::normalize(v)
    }
    /// Converts light to an integer: 0 is none, 2^24 is 1, more light is more; rounds down, saturates.
    fn light_bits(self) -> u32;
    /// Converts an integer to light, the way back from [`Self::light_bits`], for at most 2^24.
    fn from_light_bits(bits: u32) -> Self;
    /// Converts exactly, for those who watch; no picture asks for it.
    fn to_f64(self) -> f64;
    /// Answers the next larger number, for a value that is not negative.
    fn next_up(self) -> Self;
    /// Tells whether a scene may contain this value: a number, no larger than [`Self::LIMIT`].
    fn in_range(self) -> bool;

    /// Answers the magnitude.
    fn abs(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }
    /// Answers the smaller of two; the second one when they cannot be compared.
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    /// Answers the larger of two; the second one when they cannot be compared.
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
}

/// Is a sum of products of [`Scalar`]s.
pub trait Wide:
    Copy + PartialEq + PartialOrd + Debug + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self>
{
    /// Is 0.
    const ZERO: Self;

    /// Multiplies by the fraction `numerator / denominator` of two small whole numbers.
    ///
    /// The denominator is taken as at least 1.
    fn scale(self, numerator: i32, denominator: i32) -> Self;

    /// Answers the magnitude.
    fn abs(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }
}
