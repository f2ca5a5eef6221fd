//! Leading zeros, also for chips without an instruction that counts them.

#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
pub(super) use counted::leading_zeros;
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
pub(super) use searched::leading_zeros;

/// Shifts `v` up until its uppermost bit is set, unless it is 0; answers the upper 32 bits and the shift.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
pub(super) fn lift(v: u64) -> (u32, u32) {
    let (high, low) = ((v >> 32) as u32, v as u32);
    // In words: a shift of 64 bits by a variable is three of 32 and more.
    if high == 0 {
        let up = leading_zeros(low);
        return (low << up, 32 + up);
    }
    let up = leading_zeros(high);
    // Two shifts, as one by 32 places is none.
    (high << up | (low >> 1) >> (31 - up), up)
}

#[cfg(any(test, not(all(target_arch = "arm", not(target_has_atomic = "32")))))]
mod counted {
    /// Answers how many bits above the uppermost one are zero: 31 for 0, so that the answer is a shift.
    #[inline(always)]
    pub fn leading_zeros(n: u32) -> u32 {
        (n | 1).leading_zeros()
    }
}

#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
mod searched {
    /// Holds the leading zeros of 2^(n + 1) - 1 where its product with [`DE_BRUIJN`] puts them.
    static ZEROS: [u8; 32] = zeros();

    /// Is a sequence whose 32 parts of five bits all differ, times numbers of one bits (Leiserson 1998).
    const DE_BRUIJN: u32 = 0x07c4_acdd;

    const fn zeros() -> [u8; 32] {
        let mut table = [0; 32];
        let mut zeros = 0;
        while zeros < 32 {
            let ones = u32::MAX >> zeros;
            table[(ones.wrapping_mul(DE_BRUIJN) >> 27) as usize] = zeros as u8;
            zeros += 1;
        }
        table
    }

    /// Answers how many bits above the uppermost one are zero: 31 for 0, so that the answer is a shift.
    ///
    /// In 15 instructions without a branch; the compiler's own way takes 57.
    #[inline(always)]
    pub fn leading_zeros(n: u32) -> u32 {
        let mut ones = n | 1;
        for below in [1, 2, 4, 8, 16] {
            ones |= ones >> below;
        }
        u32::from(ZEROS[(ones.wrapping_mul(DE_BRUIJN) >> 27) as usize])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_are_found_where_they_are_counted() {
        let ones = (0..32).map(|bit| 1_u32 << bit);
        let numbers = ones.flat_map(|one| [one, one - 1, one | one >> 1, one | 1, u32::MAX / one]);
        for n in numbers {
            assert_eq!(searched::leading_zeros(n), counted::leading_zeros(n), "{n:#x}");
        }
    }

    #[test]
    fn lifted_numbers_are_the_shifted_ones() {
        for bit in 0..64 {
            let v = 0xf0f0_5555_aaaa_0f0f_u64 >> bit;
            let zeros = v.leading_zeros();
            assert_eq!(lift(v), (((v << zeros) >> 32) as u32, zeros), "{v:#x}");
        }
        assert_eq!(lift(0).0, 0);
    }
}
