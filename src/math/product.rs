//! Long products of 32-bit integers: the kernel under everything in fixed point.
//!
//! Most chips multiply 32 bits by 32 bits to 64 in one instruction. A Cortex-M0+ keeps the lower 32 only, and the
//! compiler's way out is a product of 64-bit numbers: there they are put together of 16-bit halves instead. The
//! results are the same bit by bit.

#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
pub(super) use halves::{high, high_by_half, high_unsigned, signed, square_high};
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
pub(super) use whole::{high, high_by_half, high_unsigned, signed, square_high};

#[cfg(any(test, not(all(target_arch = "arm", not(target_has_atomic = "32")))))]
mod whole {
    /// Answers `a * b`.
    #[inline(always)]
    pub fn signed(a: i32, b: i32) -> i64 {
        i64::from(a) * i64::from(b)
    }

    /// Answers `a * b / 2^32`, rounded down.
    #[inline(always)]
    pub fn high(a: i32, b: i32) -> i32 {
        (signed(a, b) >> 32) as i32
    }

    /// Answers `a * b / 2^32` of unsigned numbers, rounded down.
    #[inline(always)]
    pub fn high_unsigned(a: u32, b: u32) -> u32 {
        ((u64::from(a) * u64::from(b)) >> 32) as u32
    }

    /// Answers `a * b / 2^16`, rounded down.
    #[inline(always)]
    pub fn high_by_half(a: u32, b: u16) -> u32 {
        high_unsigned(a, u32::from(b) << 16)
    }

    /// Answers `a * a / 2^32`, rounded down.
    #[inline(always)]
    pub fn square_high(a: i32) -> u32 {
        high(a, a) as u32
    }
}

#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
mod halves {
    /// Answers the upper half of a number, signed, and the lower half.
    #[inline(always)]
    fn split(a: i32) -> (i32, i32) {
        (a >> 16, a & 0xffff)
    }

    /// Answers the upper word of `a * b`, and in the lower bits of the second number bits 16 to 31 of the product.
    ///
    /// No sum overflows: the largest is 0xffff * 0x7fff + 0xfffe.
    #[inline(always)]
    fn high_and_middle(a: i32, b: i32) -> (i32, i32, i32) {
        let ((a, a_low), (b, b_low)) = (split(a), split(b));
        let low = (a_low as u32 * b_low as u32) as i32;
        let first = a * b_low + (low as u32 >> 16) as i32;
        let second = a_low * b + (first & 0xffff);
        (a * b + (first >> 16) + (second >> 16), second, low)
    }

    /// Answers `a * b`, in 18 instructions and a call's 8 for the 42 of the compiler's.
    #[inline(always)]
    pub fn signed(a: i32, b: i32) -> i64 {
        let (high, middle, low) = high_and_middle(a, b);
        let low = (middle << 16) as u32 | (low as u32 & 0xffff);
        i64::from(high) << 32 | i64::from(low)
    }

    /// Answers `a * b / 2^32`, rounded down.
    #[inline(always)]
    pub fn high(a: i32, b: i32) -> i32 {
        high_and_middle(a, b).0
    }

    /// Answers `a * b / 2^32` of unsigned numbers, rounded down.
    ///
    /// By the product of signed ones: of unsigned halves the compiler makes a product of 64-bit numbers again.
    #[inline(always)]
    pub fn high_unsigned(a: u32, b: u32) -> u32 {
        let negative = |n: u32| (n as i32 >> 31) as u32;
        let signed = high(a as i32, b as i32) as u32;
        signed.wrapping_add(negative(a) & b).wrapping_add(negative(b) & a)
    }

    /// Answers `a * b / 2^16`, rounded down.
    #[inline(always)]
    pub fn high_by_half(a: u32, b: u16) -> u32 {
        let b = u32::from(b);
        (a >> 16) * b + (((a & 0xffff) * b) >> 16)
    }

    /// Answers `a * a / 2^32`, rounded down.
    #[inline(always)]
    pub fn square_high(a: i32) -> u32 {
        let (high, low) = split(a);
        // Twice the product of the halves would not fit, so the square of the lower one is halved instead.
        let middle = high * low + ((low as u32 * low as u32) >> 17) as i32;
        (high * high + (middle >> 15)) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::{halves, whole};

    /// Answers numbers at every edge of a half, and random ones.
    fn numbers() -> impl Iterator<Item = i32> + Clone {
        let edges = [0_i32, 1, 2, 0x7ffe, 0x7fff, 0x8000, 0x8001, 0xfffe, 0xffff, 0x1_0000, 0x1_0001];
        let ends = [i32::MAX, i32::MAX - 1, 0x7fff_0000, 0x7ffe_ffff, 0x4000_0000, 0x0001_ffff];
        let random = (1..600_u32).map(|i| i.wrapping_mul(0x9e37_79b9).rotate_left(i) as i32);
        let edges = edges.into_iter().chain(ends).flat_map(|n| [n, -n, !n]);
        edges.chain([i32::MIN, i32::MIN + 1]).chain(random)
    }

    #[test]
    fn products_of_halves_are_the_products() {
        let some = || numbers().step_by(if cfg!(miri) { 23 } else { 1 });
        for (a, b) in some().flat_map(|a| some().map(move |b| (a, b))) {
            assert_eq!(halves::signed(a, b), whole::signed(a, b), "{a} * {b}");
            assert_eq!(halves::high(a, b), whole::high(a, b), "{a} * {b}");
            let (a, b) = (a as u32, b as u32);
            assert_eq!(halves::high_unsigned(a, b), whole::high_unsigned(a, b), "{a} * {b}");
            let b = (b >> 16) as u16;
            assert_eq!(halves::high_by_half(a, b), whole::high_by_half(a, b), "{a} * {b}");
        }
    }

    #[test]
    fn squares_of_halves_are_the_squares() {
        for a in numbers().chain((i32::MIN..=i32::MAX).step_by(if cfg!(miri) { 6_552_101 } else { 65_521 })) {
            assert_eq!(halves::square_high(a), whole::square_high(a), "{a}");
        }
    }
}
