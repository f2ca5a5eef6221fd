//! What the kernels are measured on: numbers as they occur in scenes, the same in every run.

use scanray::Vec3;
use scanray::math::{Scalar, Wide};

/// Is how many sets of operands there are.
pub const COUNT: u32 = 128;

/// Holds the operands of one call of each kernel.
pub struct Operand<S: Scalar> {
    /// Is a vector with components up to 8.
    pub a: Vec3<S>,
    /// Is a vector with components up to 1.
    pub b: Vec3<S>,
    /// Is a share: from 1/64 to 1.
    pub t: S,
    /// Is a wide value: a squared distance up to 192.
    pub w: S::Wide,
    /// Is a wide value to divide by: from 1/64 to 1.
    pub d: S::Wide,
}

/// Holds the operands of all calls.
pub struct Operands<S: Scalar> {
    pub all: [Operand<S>; COUNT as usize],
}

impl<S: Scalar> Operands<S> {
    /// Draws them from a generator with a fixed start.
    pub fn new() -> Self {
        let mut state = 1;
        Self { all: core::array::from_fn(|_| Operand::draw(&mut state)) }
    }
}

impl<S: Scalar> Operand<S> {
    fn draw(state: &mut u32) -> Self {
        let mut part = || {
            // Knuth's linear congruential generator; its upper bits are the random ones.
            *state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            S::narrow(S::ONE.mul_wide(S::ONE).scale((*state >> 16) as i32 - 0x8000, 0x8000))
        };
        let mut vector = |size: i32| Vec3::from_array([(); 3].map(|()| part() * S::from_i32(size)));
        let (a, b) = (vector(8), vector(1));
        let t = S::max(b.x.abs(), S::HALF * S::HALF * S::HALF * S::HALF * S::HALF * S::HALF);
        Self { a, b, t, w: a.dot_wide(a), d: t.mul_wide(S::ONE) }
    }
}
