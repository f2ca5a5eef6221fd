//! Bounds of errors, and the values at which they are measured.

use scanray::Fixed;
use scanray::math::{FixedWide, Scalar};

pub const STEP: f64 = 1.0 / 1_048_576.0;

/// Runs over values and demands that the worst error reaches the bound's neighbourhood but never
/// passes it: a bound twenty times too wide fails as well.
pub fn worst_error(bound: f64, errors: impl Iterator<Item = f64>) {
    let worst = errors.fold(0.0, |worst: f64, error| {
        assert!(error.is_finite());
        worst.max(error.abs())
    });
    assert!(worst <= bound, "worst error {worst:e} passes the bound {bound:e}");
    assert!(worst >= bound / 20.0, "worst error {worst:e}: the bound {bound:e} says too little");
}

/// Positive floats of every magnitude from 2^-120 to 2^120, 4096 to a doubling.
pub fn floats() -> impl Iterator<Item = f32> {
    (7_u32..247).flat_map(|e| (0..1 << 23).step_by(2039).map(move |m| f32::from_bits(e << 23 | m)))
}

/// Fixed-point values from one step to the end of the range, ever coarser.
pub fn steps() -> impl Iterator<Item = Fixed> {
    (0..31_u32)
        .flat_map(|bits| (0..512_u64).map(move |m| (1_u64 << bits) + ((m << bits) >> 9)))
        .map(|steps| Fixed::new(steps as f64 * STEP))
}

pub fn wide(value: Fixed) -> FixedWide {
    value.mul_wide(Fixed::ONE)
}
