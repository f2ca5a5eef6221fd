use super::Candidates;
use crate::math::Scalar;
use crate::output::Encode;
use crate::trace::Bounce;
use heapless::Vec;

/// Holds all the RAM that rendering takes, beside the call stack.
///
/// `WIDTH` is the longest row it can hold, `DEPTH` the most bounces. Its size is at most
///
/// ```text
/// WIDTH * size_of::<C>() + DEPTH * size_of::<Bounce<S>>() + 96 bytes
/// ```
///
/// where a bounce takes 40 bytes in `f32` and in fixed point, and 96 hold the list of the row's
/// objects and the lengths. A `WIDTH` of 0 serves those who only call
/// [`Renderer::render_row`](crate::Renderer::render_row) with buffers of their own.
///
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb565;
/// use scanray::Workspace;
/// static WORKSPACE: Workspace<f32, Rgb565, 320, 5> = Workspace::new();
/// assert!(size_of_val(&WORKSPACE) <= 320 * 2 + 5 * 40 + 96);
/// ```
#[derive(Clone, Debug)]
pub struct Workspace<S: Scalar, C, const WIDTH: usize, const DEPTH: usize> {
    pub(super) scanline: [C; WIDTH],
    pub(super) scratch: Scratch<S, DEPTH>,
}

/// Holds what the tracing of a row takes, the row itself left out.
#[derive(Clone, Debug)]
pub(super) struct Scratch<S: Scalar, const DEPTH: usize> {
    pub waiting: Vec<Bounce<S>, DEPTH>,
    pub candidates: Candidates,
}

impl<S: Scalar, C: Encode, const WIDTH: usize, const DEPTH: usize> Workspace<S, C, WIDTH, DEPTH> {
    /// Makes a workspace; at compile time for a `static`.
    pub const fn new() -> Self {
        let scratch = Scratch { waiting: Vec::new(), candidates: Candidates::new() };
        Self { scanline: [C::DARKEST; WIDTH], scratch }
    }
}

impl<S: Scalar, C: Encode, const WIDTH: usize, const DEPTH: usize> Default for Workspace<S, C, WIDTH, DEPTH> {
    fn default() -> Self {
        Self::new()
    }
}
