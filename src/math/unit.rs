//! The direction and the length of a vector of integers, in 236 instructions on an M0+ and 99 on an M3.

use super::product::{high, square_high};
use super::root::root;
use super::zeros::leading_zeros;

/// Answers the components in steps of 2^-20 of the length, and the length in steps; `None` for zero.
///
/// The components are within a step; the length, rounded down, is within a step + 1e-8 relative.
#[inline(always)]
pub(super) fn unit([x, y, z]: [i32; 3]) -> Option<([i32; 3], i32)> {
    if x | y | z == 0 {
        return None;
    }
    // Lift the largest component to 2^30 or more, so that short vectors keep their digits. -2^n needs a bit less
    // than 2^n.
    let size = |c: i32| (c ^ (c >> 31)) as u32;
    let lift = leading_zeros(size(x) | size(y) | size(z)).wrapping_sub(1);
    let [x, y, z] = [x, y, z].map(|c| c.wrapping_shl(lift));
    // The upper words alone miss less than three units of 2^28; one more halves that.
    let square = square_high(x).wrapping_add(square_high(y)).wrapping_add(square_high(z)).wrapping_add(1);
    let even = u32::from(square >> 30 == 0);
    let root = root(square << (2 * even));
    // Component * 2^20 / length, where 1 / length = reciprocal / 2^(61 - even).
    let reciprocal = root.reciprocal >> (1 - even);
    let unit = |c: i32| high(c, reciprocal).wrapping_add(1 << 7) >> 8;
    // A length that needs no shift is 2048 or more.
    let length =
        lift.wrapping_add(even).checked_sub(1).map_or(i32::MAX as u32, |down| root.root.wrapping_shr(down));
    Some(([unit(x), unit(y), unit(z)], length.min(i32::MAX as u32) as i32))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Answers vectors from a step to the end of the range.
    fn vectors() -> impl Iterator<Item = [i32; 3]> {
        let directions = (0..if cfg!(miri) { 20 } else { 200_u32 })
            .map(|i| [1, 2, 3].map(|k| (i * k + 1).wrapping_mul(0x9e37_79b9) as i32));
        directions.flat_map(|v| (0..31).map(move |down| v.map(|c| c >> down)))
    }

    #[test]
    fn lengths_and_directions_are_right_from_a_step_to_the_end_of_the_range() {
        let mut worst = 0.0_f64;
        for v in vectors() {
            let square: f64 = v.iter().map(|&c| f64::from(c) * f64::from(c)).sum();
            let exact = <f64 as crate::Scalar>::sqrt(square);
            let (directions, length) = unit(v).expect("not zero");
            let off = exact.min(i32::MAX.into()) - f64::from(length);
            assert!((-1e-8 * exact..=1.0 + 1e-8 * exact).contains(&off), "{v:?}: {length}, not {exact}");
            for (c, direction) in v.into_iter().zip(directions) {
                worst = worst.max((f64::from(c) / exact * 1_048_576.0 - f64::from(direction)).abs());
            }
        }
        assert!((0.4..0.55).contains(&worst), "a component is off by {worst} steps");
    }
}
