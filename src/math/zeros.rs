//! Leading zeros, also for chips without an instruction that counts them.

#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
pub(super) use counted::leading_zeros;
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
pub(super) use searched::leading_zeros;

/// Shifts `v` up by an even number of places, so that one of its upper two bits is set, unless it is 0.
///
/// Answers the upper 32 bits of the result and the shift.
#[inline(always)]
pub(super) fn lift_even(v: u64) -> (u32, u32) {
    lift(v, 1)
}

/// Shifts `v` up until its uppermost bit is set; answers like [`lift_even`].
#[inline(always)]
pub(super) fn lift_fully(v: u64) -> (u32, u32) {
    lift(v, 0)
}

/// Shifts up by the leading zeros without the bits of `mask`, in words: a shift of 64 bits is three of 32 and more.
#[inline(always)]
fn lift(v: u64, mask: u32) -> (u32, u32) {
    let (high, low) = ((v >> 32) as u32, v as u32);
    if high == 0 {
        let up = leading_zeros(low) & !mask;
        return (low << (up & 31), 32 + up);
    }
    let up = leading_zeros(high) & !mask;
    // Two shifts, as one by 32 places is none.
    (high << up | (low >> 1) >> (31 - up), up)
}

#[cfg(any(test, not(all(target_arch = "arm", not(target_has_atomic = "32")))))]
mod counted {
    /// Answers how many bits above the uppermost one are zero: 32 for 0.
    #[inline(always)]
    pub fn leading_zeros(n: u32) -> u32 {
        n.leading_zeros()
    }
}

#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
mod searched {
    /// Holds the leading zeros of numbers of four bits.
    const OF_FOUR: [u8; 16] = [4, 3, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0];

    /// Answers how many bits above the uppermost one are zero: 32 for 0.
    #[inline(always)]
    pub fn leading_zeros(mut n: u32) -> u32 {
        let mut zeros = 0;
        for half in [16, 8, 4] {
            if n >> (32 - half) == 0 {
                n <<= half;
                zeros += half;
            }
        }
        zeros + u32::from(OF_FOUR.get(n as usize >> 28).copied().unwrap_or(0))
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
            assert_eq!(lift_fully(v), (((v << zeros) >> 32) as u32, zeros), "{v:#x}");
            assert_eq!(lift_even(v), (((v << (zeros & !1)) >> 32) as u32, zeros & !1), "{v:#x}");
        }
    }
}
