//! Quotients in steps of 2^-20: of wide numbers in 152 instructions on an M0+ and 69 on an M3, of plain ones in 112
//! and 60, a reciprocal in 70 and 40.

use super::reciprocal::Reciprocal;
use super::steps::FRACTION_BITS;
use super::zeros::{leading_zeros, lift};

/// Answers n / d in steps, rounded, within half a step + 1e-8 relative; `i32::MAX` or more where that is too much
/// for the range, as where d is 0.
#[inline(never)]
pub(super) fn quotient(n: u64, d: u64) -> u32 {
    let ((m, up), (divisor, down)) = (lift(n), lift(d));
    if divisor == 0 {
        return u32::MAX;
    }
    ratio_of_lifted(m, divisor, up.wrapping_sub(down))
}

/// Answers n / d of 32-bit numbers, like [`quotient`].
#[inline(never)]
pub(super) fn ratio(n: u32, d: u32) -> u32 {
    if d == 0 {
        return u32::MAX;
    }
    let (up, down) = (leading_zeros(n), leading_zeros(d));
    ratio_of_lifted(n << up, d << down, up.wrapping_sub(down))
}

/// Answers n / (d 2^`down`) in steps; of both numbers the uppermost bit is set, unless n is 0.
#[inline(always)]
fn ratio_of_lifted(n: u32, d: u32, down: u32) -> u32 {
    // half is n / d in fractions of 2^30.
    let half = Reciprocal::of(d).times_half(n >> 1);
    shift_down(half, down.wrapping_add(30 - FRACTION_BITS))
}

/// Answers 1 / d of d steps, like [`quotient`].
#[inline(never)]
pub(super) fn reciprocal(d: u32) -> u32 {
    if d == 0 {
        return u32::MAX;
    }
    let down = leading_zeros(d);
    // 2^40 / d = value / 2^62 * 2^(40 + down).
    shift_down(Reciprocal::of(d << down).value(), 22_u32.wrapping_sub(down))
}

/// Answers n / 2^`places`, rounded; n is at least 2^29, and what a negative number of places leaves too long is
/// answered by the largest number.
#[inline(always)]
fn shift_down(n: u32, places: u32) -> u32 {
    match places {
        0..32 => n.wrapping_add((1 << places) >> 1) >> places,
        u32::MAX => n.saturating_add(n),
        0x8000_0000.. => u32::MAX,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Demands that `near`, in the range of the numbers, is n / d in steps.
    fn check(near: u32, n: u64, d: u64) {
        let exact = ((u128::from(n) << FRACTION_BITS) / u128::from(d)).min(i32::MAX as u128) as u32;
        let off = near.min(i32::MAX as u32).abs_diff(exact);
        assert!(off <= 1 + exact / 100_000_000, "{n} / {d} = {near}, not {exact}");
    }

    /// Answers numbers of every length with every kind of digits.
    fn numbers(bits: u32) -> impl Iterator<Item = u64> + Clone {
        let lengths = (64 - bits..64).step_by(if cfg!(miri) { 7 } else { 1 });
        lengths.flat_map(|zeros| [1 << 63, u64::MAX, 0xb504_f333_f9de_6484].map(|n| n >> zeros))
    }

    #[test]
    fn quotients_are_right_or_saturate() {
        for (n, d) in numbers(63).flat_map(|n| numbers(63).map(move |d| (n, d))) {
            check(quotient(n, d), n, d);
        }
        for (n, d) in numbers(32).flat_map(|n| numbers(32).map(move |d| (n, d))) {
            check(ratio(n as u32, d as u32), n, d);
            check(reciprocal(d as u32), 1 << FRACTION_BITS, d);
        }
    }

    #[test]
    fn nothing_divided_is_nothing_and_a_division_by_nothing_saturates() {
        assert_eq!([quotient(0, 5), ratio(0, 5)], [0, 0]);
        assert_eq!([quotient(5, 0), ratio(5, 0), reciprocal(0)], [u32::MAX; 3]);
    }
}
