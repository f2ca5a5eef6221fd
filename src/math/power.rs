//! Powers of fractions: the 32nd in 102 instructions on an M0+ and 15 on an M3.

use super::product::high_unsigned;

/// Answers x^`exponent` of x = `fraction` / 2^32, rounded down again and again: within (`exponent` + 1) / 2^32.
#[inline(never)]
pub(super) fn power(fraction: u32, exponent: u16) -> u32 {
    let (mut base, mut left, mut product) = (fraction, exponent, u32::MAX);
    // Half of the squares of a highlight's exponent come before its first factor.
    while left > 0 {
        if left & 1 == 1 {
            product = if product == u32::MAX { base } else { high_unsigned(product, base) };
        }
        left >>= 1;
        if left > 0 {
            base = high_unsigned(base, base);
        }
    }
    product
}
