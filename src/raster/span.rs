//! What the plane of a row cuts out of a flat convex face: a span of columns along which nearness grows
//! evenly.

use super::depths::{Painter, stepped};
use super::slice::Slice;
use crate::math::Scalar;
use crate::trace::Observer;

/// Is a point of the row's plane as the camera sees it, with all that was known of it.
#[derive(Clone, Copy)]
pub(super) struct End<S, const N: usize> {
    pub slope: S,
    pub nearness: S,
    /// p, q, off the plane, and what the face carries there.
    pub point: [S; N],
}

/// Is the visible piece of a face in a row, from the left to the right.
#[derive(Clone, Copy)]
pub(super) struct Span<S, const N: usize> {
    pub left: End<S, N>,
    pub right: End<S, N>,
}

impl<S: Scalar, const N: usize> Span<S, N> {
    /// Cuts, clips and projects a face, given by its corners in order around it: each by p, q, how far it
    /// lies off the row's plane, and whatever else is even over the face.
    pub fn of(slice: &Slice<S>, corners: &[[S; N]]) -> Option<Self> {
        let [a, b] = slice.clip(section(corners)?)?.map(|point| End::of(slice, point));
        Some(if a.slope <= b.slope { Self { left: a, right: b } } else { Self { left: b, right: a } })
    }

    /// Puts the piece into the row of depths.
    pub fn paint<O: Observer>(&self, slice: &Slice<S>, part: u16, painter: &mut Painter<'_, S, O>) {
        let columns = slice.columns([self.left.slope, self.right.slope]);
        let (rise, run) = (self.right.nearness - self.left.nearness, self.right.slope - self.left.slope);
        if columns.is_empty() {
            return;
        }
        let step = slice.step(rise, run);
        let slopes = slice.ramp(Slice::SLOPE);
        painter.paint(columns, part, |x| {
            let along = slopes.from(x).next().unwrap_or(self.left.slope) - self.left.slope;
            let risen = S::div(rise.mul_wide(along), run.mul_wide(S::ONE));
            stepped(self.left.nearness + risen, step)
        });
    }
}

impl<S: Scalar, const N: usize> End<S, N> {
    fn of(slice: &Slice<S>, point: [S; N]) -> Self {
        let (p, q) = match point.as_slice() {
            [p, q, ..] => (*p, *q),
            _ => (S::ZERO, S::ONE),
        };
        let slope = if slice.fan.parallel { p } else { p.ratio(q) };
        Self { slope, nearness: slice.nearness(q), point }
    }
}

/// Answers where the edges around a face pass through the plane of the row, if they do.
fn section<S: Scalar, const N: usize>(corners: &[[S; N]]) -> Option<[[S; N]; 2]> {
    let (mut rising, mut falling) = (None, None);
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        match (off(a) < S::ZERO, off(b) < S::ZERO) {
            (true, false) => rising = Some(crossing(a, b)),
            (false, true) => falling = Some(crossing(b, a)),
            _ => {}
        }
    }
    Some([rising?, falling?])
}

/// Answers how far a corner lies off the plane of the row.
fn off<S: Scalar, const N: usize>(corner: &[S; N]) -> S {
    corner.get(2).copied().unwrap_or(S::ZERO)
}

/// Answers the point of an edge in the plane of the row.
///
/// The ends are always taken in the same order, so that two faces at one edge have the same bits and no
/// pixel between them is lost; products are wide, so that it is off by no more than a step.
fn crossing<S: Scalar, const N: usize>(below: &[S; N], above: &[S; N]) -> [S; N] {
    let (low, high) = (off(below), off(above));
    let rise = (high - low).mul_wide(S::ONE);
    let mut point = *below;
    for (at, other) in point.iter_mut().zip(above) {
        *at = S::div(at.mul_wide(high) - other.mul_wide(low), rise);
    }
    point
}
