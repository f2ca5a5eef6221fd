//! The reciprocal of 32-bit integers: the kernel under fixed-point division.
//!
//! A Cortex-M3 divides 64 bits in software, an M0+ any number: seven products cost less than one
//! such division on both.

/// Answers 2^62 / `m`, where `m` is at least 2^31, within 2e-9 relative.
///
/// The seed is the line 48/17 - 32/17 x, within 1/17 for x = m / 2^32 from 1/2 to 1; each of three
/// Newton steps y (2 - x y) squares the error, down to 2e-10, and the rest is rounding.
pub(super) fn reciprocal(m: u32) -> u32 {
    const OFFSET: u32 = (48 * (1_u64 << 30) / 17) as u32;
    const SLOPE: u64 = 32 * (1_u64 << 30) / 17;
    let mut y = OFFSET - ((SLOPE * u64::from(m)) >> 32) as u32;
    for _ in 0..3 {
        // y is a fraction of 2^30, x y and 2 - x y are fractions of 2^31.
        let product = (u64::from(m) * u64::from(y)) >> 31;
        let factor = (1_u64 << 32) - product;
        y = ((u64::from(y) * factor) >> 31) as u32;
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reciprocals_are_right_over_the_whole_range() {
        let edges = [1 << 31, (1 << 31) + 1, u32::MAX - 1, u32::MAX];
        let inside = (1_u32 << 31..=u32::MAX).step_by(1021);
        let worst = inside.chain(edges).map(|m| {
            let exact = ((1_u64 << 62) / u64::from(m)) as i64;
            let off = (i64::from(reciprocal(m)) - exact).abs();
            // In units of 1e-10 of the answer.
            off * 10_000_000_000 / exact
        });
        let worst = worst.max().unwrap_or(0);
        assert!((1..=20).contains(&worst), "worst error {worst}e-10");
    }
}
