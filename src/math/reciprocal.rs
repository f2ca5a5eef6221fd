//! The reciprocal of 32-bit integers: the kernel under fixed-point division.
//!
//! A Cortex-M3 divides 64 bits in software, an M0+ any number: a few products cost less than one such division on
//! both.

use super::product::high_by_half;
use super::seed::{entry, seed};

/// Holds 1/x over each 1/128 of x from 1/2 to 1.
static LINES: [u32; 64] = lines();

const fn lines() -> [u32; 64] {
    let mut table = [0; 64];
    let mut i = 0;
    while i < 64 {
        // x = n / 256, so 2^20 / x = 2^28 / n.
        let n = 2 * (64 + i) as u32;
        let [start, middle, end] = [(1 << 28) / n, (1 << 28) / (n + 1), (1 << 28) / (n + 2)];
        // The chord lies above the curve, most in the middle: half of that below keeps the error smallest.
        let above = (start + end - 2 * middle) / 4;
        table[i] = entry((start - above + 8) >> 4, start - end);
        i += 1;
    }
    table
}

/// Answers 2^15 / x for x = `m` / 2^32, where `m` is at least 2^31, within 5e-5 relative.
#[inline(always)]
pub(crate) fn rough_reciprocal(m: u32) -> u16 {
    seed(&LINES, m)
}

/// Is 1/x for x from 1/2 to 1, in two parts: 2^15 / x within 5e-5, and what x times that misses of 1.
///
/// The miss r is so small that the step y (1 + r) ends with a product of 32 bits, whatever is to be divided.
pub(super) struct Reciprocal {
    rough: u16,
    missing: i32,
}

impl Reciprocal {
    /// Takes x = `m` / 2^32, where `m` is at least 2^31.
    #[inline(always)]
    pub fn of(m: u32) -> Self {
        let rough = rough_reciprocal(m);
        let missing = (1_u32 << 31).wrapping_sub(high_by_half(m, rough)) as i32 >> 2;
        Self { rough, missing }
    }

    /// Answers 2^30 / x, within 4e-9 relative.
    #[inline(always)]
    pub fn value(&self) -> u32 {
        let y = u32::from(self.rough);
        (y << 15).wrapping_add_signed((y as i32).wrapping_mul(self.missing) >> 14)
    }

    /// Answers n / (2 x), within 6e-9 relative and a unit; `n` is below 2^31.
    #[inline(always)]
    pub fn times_half(&self, n: u32) -> u32 {
        let product = high_by_half(n, self.rough);
        product.wrapping_add_signed(((product >> 16) as i32).wrapping_mul(self.missing) >> 13)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Answers numbers in every interval of the table.
    fn divisors() -> impl Iterator<Item = u32> {
        let edges = [1 << 31, (1 << 31) + 1, u32::MAX - 1, u32::MAX];
        (1_u32 << 31..=u32::MAX).step_by(if cfg!(miri) { 4_084_003 } else { 1021 }).chain(edges)
    }

    /// Answers the greatest difference, in units of 1e-10 of the exact number.
    fn worst(answers: impl Iterator<Item = (u32, u64)>) -> i64 {
        let errors = answers
            .map(|(near, exact)| (i64::from(near) - exact as i64).abs() * 10_000_000_000 / exact as i64);
        errors.max().unwrap_or(0)
    }

    #[test]
    fn reciprocals_are_right_over_the_whole_range() {
        let worst = worst(divisors().map(|m| (Reciprocal::of(m).value(), (1 << 62) / u64::from(m))));
        assert!((10..=40).contains(&worst), "worst error {worst}e-10");
    }

    #[test]
    fn quotients_are_right_over_the_whole_range() {
        for n in [1_u32 << 30, 0x5555_5555, i32::MAX as u32] {
            let quotients =
                divisors().map(|m| (Reciprocal::of(m).times_half(n), (u64::from(n) << 31) / u64::from(m)));
            let worst = worst(quotients);
            assert!((10..=60).contains(&worst), "worst error {worst}e-10");
        }
    }
}
