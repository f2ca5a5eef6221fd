//! Straight lines between the points of a table: where the kernels of roots and reciprocals start.
//!
//! An entry holds what the function is at the start of its interval, in 17 bits, and how far it falls to the end, in
//! 15. A line and one Newton step take the place of three Newton steps from a plain table.

/// Packs an entry: values of 2^16 and of 2^20, the line's start already lowered into the middle of the error.
pub(super) const fn entry(start: u32, fall: u32) -> u32 {
    start << 15 | fall
}

/// Answers the table's line at `m`, as a fraction of 2^15; the upper bits of `m` choose among 128 intervals, or among
/// the later 64.
#[inline(always)]
pub(super) fn seed<const N: usize>(table: &[u32; N], m: u32) -> u16 {
    let entry = table[(m >> 25) as usize % N];
    let share = (m << 7) >> 16;
    let fall = ((entry & 0x7fff) * share) >> 20;
    ((entry >> 15).wrapping_sub(fall) >> 1) as u16
}
