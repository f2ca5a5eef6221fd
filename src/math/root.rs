//! The square root of 32-bit integers and its reciprocal: the kernel under fixed-point roots and lengths.
//!
//! A square root of a wide number takes 89 instructions on an M0+ and 40 on an M3.

use super::product::high_by_half;
use super::seed::{entry, seed};
use super::zeros::lift;

/// Holds 1/sqrt(x) over each 1/128 of x from 1/4 to 1. The first quarter is never asked for: 128 bytes of flash spare
/// each root a check of its index, six instructions on an M0+.
static LINES: [u32; 128] = lines();

const fn lines() -> [u32; 128] {
    let mut table = [0; 128];
    let mut i = 32;
    while i < 128 {
        // x = n / 256, so (2^20 / sqrt(x))^2 = 2^48 / n.
        let n = 2 * i as u64;
        let [start, middle, end] =
            [((1 << 48) / n).isqrt(), ((1 << 48) / (n + 1)).isqrt(), ((1 << 48) / (n + 2)).isqrt()];
        // The chord lies above the curve, most in the middle: half of that below keeps the error smallest.
        let above = (start + end - 2 * middle) / 4;
        table[i] = entry(((start - above + 8) >> 4) as u32, (start - end) as u32);
        i += 1;
    }
    table
}

/// Is what [`root`] answers for x = m / 2^32.
pub(super) struct Root {
    /// Is 2^31 sqrt(x), within 6e-9 relative.
    pub root: u32,
    /// Is 2^29 / sqrt(x), within 6e-9 relative.
    pub reciprocal: i32,
}

/// Answers the root of `m`, which is at least 2^30.
///
/// The seed y is within 6e-5, and what it misses, r = 1 - x y y, is so small that one step y (1 + r / 2) ends with
/// a product of 32 bits.
#[inline(always)]
pub(super) fn root(m: u32) -> Root {
    let y = seed(&LINES, m);
    let rough = high_by_half(m, y);
    let missing = (1_i32 << 30).wrapping_sub(high_by_half(rough, y) as i32) >> 2;
    let y = i32::from(y);
    Root {
        root: rough.wrapping_add_signed(((rough >> 16) as i32).wrapping_mul(missing) >> 13),
        reciprocal: (y << 14) + (y.wrapping_mul(missing) >> 15),
    }
}

/// Answers the square root of `v`, rounded, within 1e-8 relative and one unit; at most `i32::MAX`.
pub(super) fn sqrt(v: u64) -> i32 {
    if v == 0 {
        return 0;
    }
    let (m, up) = lift(v);
    // An even shift has a root; the places that are lost are 31 below the first.
    let (m, even) = (m >> (up & 1), up & !1);
    // sqrt(v) = root / 2^31 * 2^32 / 2^(even / 2).
    let Some(down) = (even / 2).checked_sub(1) else { return i32::MAX };
    let rounded = root(m).root.wrapping_add(1_u32.wrapping_shl(down) >> 1).wrapping_shr(down);
    rounded.min(i32::MAX as u32) as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check_root(v: u64) {
        let (exact, near) = ((v.isqrt() as i64).min(i32::MAX.into()), i64::from(sqrt(v)));
        let allowed = 1 + exact / 100_000_000;
        assert!((near - exact).abs() <= allowed, "sqrt({v}) = {near}, not {exact}");
    }

    #[test]
    fn roots_are_right_in_every_interval_of_the_table() {
        for m in (1_u64 << 30..1 << 32).step_by(if cfg!(miri) { 4_099_001 } else { 4099 }) {
            check_root(m << 31);
            check_root(m << 30);
            check_root(m << 9);
        }
    }

    #[test]
    fn reciprocal_roots_are_right_in_every_interval_of_the_table() {
        let errors = (1_u32 << 30..=u32::MAX).step_by(if cfg!(miri) { 4_084_003 } else { 1021 }).map(|m| {
            // (2^29 / sqrt(m / 2^32))^2 = 2^90 / m.
            let exact = ((1_u128 << 90) / u128::from(m)).isqrt() as i64;
            // In units of 1e-10 of the answer.
            (i64::from(root(m).reciprocal) - exact).abs() * 10_000_000_000 / exact
        });
        let worst = errors.max().unwrap_or(0);
        assert!((10..=60).contains(&worst), "worst error {worst}e-10");
    }

    #[test]
    fn roots_of_small_numbers_and_of_the_ends_are_right() {
        (0..70_000).step_by(if cfg!(miri) { 101 } else { 1 }).for_each(check_root);
        check_root(u64::MAX);
        check_root(1 << 62);
        check_root((1 << 62) - 1);
    }
}
