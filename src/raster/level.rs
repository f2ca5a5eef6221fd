use super::depths::Painter;
use super::slice::{Line, Slice};
use crate::math::Scalar;
use crate::shape::Plane;
use crate::trace::Observer;

/// Puts an endless plane into the row of depths, up to its horizon.
///
/// With its unit normal n and its height h over the eye it is at `q (n_p slope + n_q) = h`, and of
/// parallel rays at `n_p slope + n_q q = h`: nearness is a line in either.
pub(super) fn paint<S: Scalar, O: Observer>(
    plane: &Plane<S>,
    slice: &Slice<S>,
    painter: &mut Painter<'_, S, O>,
) {
    let Some((normal, _)) = plane.normal.normalize() else { return };
    let height = (plane.point - slice.fan.apex).dot(normal);
    let [along, toward] = [slice.fan.along, slice.fan.toward].map(|axis| normal.dot(axis));
    let (divisor, [offset, factor]) =
        if slice.fan.parallel { (toward, [-height, along]) } else { (height, [toward, along]) };
    if divisor == S::ZERO {
        return;
    }
    let over = |value: S| S::div(value.mul_wide(slice.scale), divisor.mul_wide(S::ONE));
    let (offset, factor) = (over(offset), over(factor));
    let mut slopes = slice.window();
    if slice.nearest < S::FAR {
        slopes = slice.positive(slopes, Line { offset: slice.nearest - offset, factor: -factor });
    }
    slopes = slice.positive(slopes, Line { offset: offset - slice.farthest, factor });
    let nearness = slice.ramp(Line { offset, factor });
    painter.paint(slice.columns(slopes), 0, |x| nearness.from(x));
}
