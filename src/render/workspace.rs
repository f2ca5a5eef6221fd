use super::Spans;
use crate::math::Scalar;
use crate::output::Encode;
use crate::trace::{Packet, Pending, Vicinities};

/// Holds all the RAM that rendering takes, beside the call stack.
///
/// `WIDTH` is the longest row it can hold, `DEPTH` the most mirrors and surfaces of glass that light may have met on
/// its way. Its size is at
/// most
///
/// ```text
/// WIDTH * size_of::<C>() + DEPTH * 44 + 1288 bytes
/// ```
///
/// on a device with 32-bit addresses, in `f32` and in fixed point: eight rays on their way take
/// 704, the spans of a row 384, and what is remembered of shadows 192; a ray that waits at a surface of glass takes
/// 44, and there is one a level. A `WIDTH` of 0 serves those
/// who only call [`Renderer::render_row`](crate::Renderer::render_row) with buffers of their own.
///
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb565;
/// use scanray::Workspace;
/// static WORKSPACE: Workspace<f32, Rgb565, 320, 5> = Workspace::new();
/// assert!(size_of_val(&WORKSPACE) <= 320 * 2 + 5 * 44 + 1288);
/// ```
#[derive(Clone, Debug)]
pub struct Workspace<S: Scalar, C, const WIDTH: usize, const DEPTH: usize> {
    pub(super) scanline: [C; WIDTH],
    pub(super) scratch: ScratchOf<S, [Pending<S>; DEPTH]>,
}

/// Is a [`ScratchOf`] seen without its depth, so that the code is the same for all.
pub(super) type Scratch<S> = ScratchOf<S, [Pending<S>]>;

/// Holds what the tracing of a row takes, the row itself left out.
#[derive(Clone, Debug)]
pub(super) struct ScratchOf<S: Scalar, P: ?Sized> {
    pub packet: Packet<S>,
    pub spans: Spans,
    pub vicinities: Vicinities<S>,
    /// Places for rays that wait, one for each mirror or glass surface that a ray may meet.
    pub pending: P,
}

impl<S: Scalar, C: Encode, const WIDTH: usize, const DEPTH: usize> Workspace<S, C, WIDTH, DEPTH> {
    /// Is a workspace before any picture: all zeros, so that a `static` takes no flash.
    ///
    /// A constant, for what is made of its parts when it is needed is made of each of them in turn, and both lie
    /// on the stack: 1564 bytes of it for 40 columns.
    const EMPTY: Self = Self {
        scanline: [C::DARKEST; WIDTH],
        scratch: ScratchOf {
            packet: Packet::new(),
            spans: Spans::new(),
            vicinities: Vicinities::new(),
            pending: [Pending::NONE; DEPTH],
        },
    };

    /// Makes a workspace; at compile time for a `static`.
    pub const fn new() -> Self {
        Self::EMPTY
    }
}

impl<S: Scalar, C: Encode, const WIDTH: usize, const DEPTH: usize> Default for Workspace<S, C, WIDTH, DEPTH> {
    fn default() -> Self {
        Self::new()
    }
}
