use super::depths::Fragment;
use crate::math::Scalar;

/// Holds all the RAM that rasterising takes, beside the call stack: a row of depths, and what lies there.
///
/// `WIDTH` is the longest row it can hold. Its size is
///
/// ```text
/// WIDTH * 8 bytes
/// ```
///
/// in `f32` and in fixed point: four for a depth, two each for the object and its part. There is no
/// scanline: colours are made when the display takes them.
///
/// ```
/// use scanray::RasterWorkspace;
/// static WORKSPACE: RasterWorkspace<f32, 320> = RasterWorkspace::new();
/// assert_eq!(size_of_val(&WORKSPACE), 320 * 8);
/// ```
#[derive(Clone, Debug)]
pub struct RasterWorkspace<S: Scalar, const WIDTH: usize> {
    pub(super) row: [Fragment<S>; WIDTH],
}

impl<S: Scalar, const WIDTH: usize> RasterWorkspace<S, WIDTH> {
    /// Makes a workspace; at compile time for a `static`.
    pub const fn new() -> Self {
        Self { row: [Fragment::empty(S::ZERO); WIDTH] }
    }
}

impl<S: Scalar, const WIDTH: usize> Default for RasterWorkspace<S, WIDTH> {
    fn default() -> Self {
        Self::new()
    }
}
