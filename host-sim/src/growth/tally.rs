use crate::rounded::Rounded;
use scanray::Scalar;
use scanray::math::{Arctangent, Wide};
use std::cell::Cell;
use std::ops::{Add, Mul, Neg, Sub};

thread_local! {
    static OPERATIONS: Cell<Operations> = const { Cell::new(Operations::NONE) };
}

/// Counts operations of a number by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Sums and differences.
    pub sums: u64,
    /// Products.
    pub products: u64,
    /// Quotients and reciprocals.
    pub quotients: u64,
    /// Square roots.
    pub roots: u64,
    /// Powers and exponentials.
    pub powers: u64,
}

impl Operations {
    const NONE: Self = Self { sums: 0, products: 0, quotients: 0, roots: 0, powers: 0 };

    /// Answers how many there are of all kinds.
    pub fn total(&self) -> u64 {
        self.sums + self.products + self.quotients + self.roots + self.powers
    }
}

impl Sub for Operations {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Self {
            sums: self.sums - rhs.sums,
            products: self.products - rhs.products,
            quotients: self.quotients - rhs.quotients,
            roots: self.roots - rhs.roots,
            powers: self.powers - rhs.powers,
        }
    }
}

/// Is `f64` that counts what is done with it: sums, products, quotients and roots, on each thread by itself.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Tally(f64);

impl Tally {
    /// Answers how many operations this thread has done so far.
    pub fn operations() -> u64 {
        Self::by_kind().total()
    }

    /// Answers the same by kind.
    pub fn by_kind() -> Operations {
        OPERATIONS.get()
    }

    /// Takes the answer of one operation.
    fn of(kind: fn(&mut Operations) -> &mut u64, value: f64) -> Self {
        let mut operations = OPERATIONS.get();
        *kind(&mut operations) += 1;
        OPERATIONS.set(operations);
        Self(value)
    }

    fn sum(value: f64) -> Self {
        Self::of(|operations| &mut operations.sums, value)
    }

    fn product(value: f64) -> Self {
        Self::of(|operations| &mut operations.products, value)
    }

    fn quotient(value: f64) -> Self {
        Self::of(|operations| &mut operations.quotients, value)
    }

    fn root(value: f64) -> Self {
        Self::of(|operations| &mut operations.roots, value)
    }

    fn power(value: f64) -> Self {
        Self::of(|operations| &mut operations.powers, value)
    }
}

impl Add for Tally {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self::sum(self.0 + rhs.0)
    }
}

impl Sub for Tally {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Self::sum(self.0 - rhs.0)
    }
}

impl Mul for Tally {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        Self::product(self.0 * rhs.0)
    }
}

impl Neg for Tally {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Rounded for Tally {
    fn round(value: f64) -> Self {
        Self(value)
    }
}

impl Wide for Tally {
    const ZERO: Self = Self(0.0);

    fn scale(self, numerator: i32, denominator: i32) -> Self {
        Self::product(Wide::scale(self.0, numerator, denominator))
    }
}

/// Holds the terms by which `f64` finds angles.
const SERIES: [Tally; f64::ARCTANGENT.series.len()] = {
    let mut terms = [Tally(0.0); f64::ARCTANGENT.series.len()];
    let mut i = 0;
    while i < terms.len() {
        terms[i] = Tally(f64::ARCTANGENT.series[i]);
        i += 1;
    }
    terms
};

impl Scalar for Tally {
    type Wide = Self;

    const EXACT_PRODUCTS: bool = f64::EXACT_PRODUCTS;
    const ZERO: Self = Self(<f64 as Scalar>::ZERO);
    const ONE: Self = Self(f64::ONE);
    const HALF: Self = Self(f64::HALF);
    const BELOW_ONE: Self = Self(f64::BELOW_ONE);
    const PARALLEL: Self = Self(f64::PARALLEL);
    const PI: Self = Self(f64::PI);
    const FAR: Self = Self(f64::FAR);
    const FAR_BACK: Self = Self(f64::FAR_BACK);
    const SLACK: Self = Self(f64::SLACK);
    const FADED: Self = Self(f64::FADED);
    const LIMIT: Self = Self(f64::LIMIT);
    const SKIN: Self = Self(f64::SKIN);
    const ARCTANGENT: Arctangent<Self> =
        Arctangent { sixteenth: Self(f64::ARCTANGENT.sixteenth), series: &SERIES };

    fn from_i32(n: i32) -> Self {
        Self(f64::from(n))
    }

    fn mul_wide(self, rhs: Self) -> Self {
        self * rhs
    }

    fn narrow(wide: Self) -> Self {
        wide
    }

    fn sqrt(wide: Self) -> Self {
        Self::root(Scalar::sqrt(wide.0))
    }

    fn div(numerator: Self, denominator: Self) -> Self {
        Self::quotient(f64::div(numerator.0, denominator.0))
    }

    fn ratio(self, divisor: Self) -> Self {
        Self::div(self, divisor)
    }

    fn recip(self) -> Self {
        Self::quotient(Scalar::recip(self.0))
    }

    fn floor(wide: Self) -> i32 {
        <f64 as Scalar>::floor(wide.0)
    }

    fn fract(wide: Self) -> Self {
        Self(<f64 as Scalar>::fract(wide.0))
    }

    fn pow_unit(self, exponent: u16) -> Self {
        Self::power(self.0.pow_unit(exponent))
    }

    fn exp_neg(self) -> Self {
        Self::power(self.0.exp_neg())
    }

    fn normalize(v: [Self; 3]) -> Option<([Self; 3], Self)> {
        let (unit, length) = f64::normalize(v.map(|value| value.0))?;
        Some((unit.map(Self::product), Self::root(length)))
    }

    fn light_bits(self) -> u32 {
        self.0.light_bits()
    }

    fn from_light_bits(bits: u32) -> Self {
        Self(f64::from_light_bits(bits))
    }

    fn to_f64(self) -> f64 {
        self.0
    }

    fn next_up(self) -> Self {
        Self(Scalar::next_up(self.0))
    }

    fn in_range(self) -> bool {
        self.0.in_range()
    }
}
