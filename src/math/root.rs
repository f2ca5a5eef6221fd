//! The reciprocal square root of 32-bit integers: the kernel under fixed-point roots and lengths.

/// Holds 1/sqrt(x) in the middle of each 1/64 of x from 1/4 to 1, as a fraction of 2^30.
const SEEDS: [u32; 48] = seeds();

const fn seeds() -> [u32; 48] {
    let mut table = [0; 48];
    let mut i = 0;
    while i < 48 {
        // x = (2 i + 33) / 128, so (2^30 / sqrt(x))^2 = 2^67 / (2 i + 33).
        let square = (1_u128 << 67) / (2 * i as u128 + 33);
        table[i] = square.isqrt() as u32;
        i += 1;
    }
    table
}

/// Answers 2^30 / sqrt(x) for x = `m` / 2^32, where `m` is at least 2^30.
///
/// The seed is within 1.6 %; three Newton steps leave the rounding of 32-bit products, at most
/// 4e-9 relative.
pub(super) fn rsqrt(m: u32) -> u32 {
    let index = ((m >> 26) as usize).saturating_sub(16);
    let mut y = match SEEDS.get(index) {
        Some(seed) => *seed,
        None => 1 << 30,
    };
    for _ in 0..3 {
        // y is a fraction of 2^30; its square and x * y * y are fractions of 2^29.
        let square = (u64::from(y) * u64::from(y)) >> 31;
        let residue = (u64::from(m) * square) >> 32;
        let factor = (3_u64 << 29).saturating_sub(residue);
        y = ((u64::from(y) * factor) >> 30) as u32;
    }
    y
}

/// Answers the square root of `v`, rounded, within 4e-9 relative and one unit.
pub(super) fn sqrt(v: u64) -> u64 {
    if v == 0 {
        return 0;
    }
    let (root, shift) = scaled_root(v);
    (root + ((1 << shift) >> 1)) >> shift
}

/// Answers r and s with sqrt(v) = r / 2^s, r having 32 significant bits; `v` is not 0.
fn scaled_root(v: u64) -> (u64, u32) {
    let even = v.leading_zeros() & !1;
    let m = ((v << even) >> 32) as u32;
    ((u64::from(m) * u64::from(rsqrt(m))) >> 30, even / 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check_root(v: u64) {
        let (exact, near) = (v.isqrt() as i64, sqrt(v) as i64);
        let allowed = 1 + exact / 250_000_000;
        assert!((near - exact).abs() <= allowed, "sqrt({v}) = {near}, not {exact}");
    }

    #[test]
    fn roots_are_right_in_every_interval_of_the_table() {
        for m in (1_u64 << 30..1 << 32).step_by(4099) {
            check_root(m << 32);
            check_root(m << 9);
        }
    }

    #[test]
    fn roots_of_small_numbers_and_of_the_ends_are_right() {
        (0..70_000).for_each(check_root);
        check_root(u64::MAX);
        check_root(1 << 62);
    }
}
