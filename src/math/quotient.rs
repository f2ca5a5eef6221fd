//! Quotients in steps of 2^-20.

use super::reciprocal::Reciprocal;
use super::steps::FRACTION_BITS;
use super::zeros::{leading_zeros, lift_fully};

/// Answers n / d in steps, rounded, within half a step + 1e-8 relative; `i32::MAX` or more where that is too much
/// for the range, as where d is 0.
#[inline(never)]
pub(super) fn quotient(n: u64, d: u64) -> u32 {
    let ((m, up), (divisor, down)) = (lift_fully(n), lift_fully(d));
    if divisor == 0 {
        return u32::MAX;
    }
    let half = Reciprocal::of(divisor).times_half(m >> 1);
    // n / d = half / 2^30 * 2^(down - up).
    shift_down(half, (up + 30 - FRACTION_BITS).wrapping_sub(down))
}

/// Answers 1 / d of d steps, like [`quotient`].
#[inline(never)]
pub(super) fn reciprocal(d: u32) -> u32 {
    let down = leading_zeros(d);
    if d == 0 {
        return u32::MAX;
    }
    // 2^40 / d = value / 2^62 * 2^(40 + down).
    shift_down(Reciprocal::of(d << down).value(), 22_u32.wrapping_sub(down))
}

/// Answers n / 2^`places`, rounded; n is at least 2^29, and what a negative number of places leaves too long is
/// answered by the largest number.
#[inline(always)]
fn shift_down(n: u32, places: u32) -> u32 {
    match places {
        0..32 => (n + ((1 << places) >> 1)) >> places,
        u32::MAX => n.saturating_add(n),
        0x8000_0000.. => u32::MAX,
        _ => 0,
    }
}
