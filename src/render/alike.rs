/// Is the most that a channel may change between two samples, as a fraction of 2^16: two steps of five
/// bits. What is filled in lies between them, and mostly within a tenth of this of what is there.
const ALIKE: u16 = (2 * 65_536 / 31) as u16;

/// Tells whether no level of a sample is further from the other's than two steps of five bits.
pub(super) fn are_alike(a: &[u16; 3], b: &[u16; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) <= ALIKE)
}

/// Answers a level in 16 bits: white is 2^16, and the level below it is rounded to the same by every
/// threshold there is.
pub(super) fn short(level: u32) -> u16 {
    level.min(u32::from(u16::MAX)) as u16
}
