use super::depths::{Painter, stepped};
use super::slice::{Line, Slice};
use crate::math::Scalar;
use crate::shape::Plane;
use crate::trace::Observer;

/// Puts an endless plane into the row of depths, up to its horizon.
pub(super) fn paint<S: Scalar, O: Observer>(
    plane: &Plane<S>,
    slice: &Slice<S>,
    painter: &mut Painter<'_, S, O>,
) {
    let Some((normal, _)) = plane.normal.normalize() else { return };
    let height = (plane.point - slice.fan.apex).dot(normal);
    let [along, toward] = [slice.fan.along, slice.fan.toward].map(|axis| normal.dot(axis));
    if slice.fan.parallel {
        let sign = if toward < S::ZERO { -S::ONE } else { S::ONE };
        paint_parallel(Line { offset: -height * sign, factor: along * sign }, toward.abs(), slice, painter);
    } else if height != S::ZERO {
        // The plane is at q (n_p slope + n_q) = height, so that its nearness is a line.
        let over = |value: S| S::div(value.mul_wide(slice.scale), height.mul_wide(S::ONE));
        paint_line(Line { offset: over(toward), factor: over(along) }, slice, painter);
    }
}

fn paint_line<S: Scalar, O: Observer>(line: Line<S>, slice: &Slice<S>, painter: &mut Painter<'_, S, O>) {
    let Line { offset, factor } = line;
    let mut slopes = slice.positive(slice.window(), Line { offset: offset - slice.farthest, factor });
    if slice.nearest < S::FAR {
        slopes = slice.positive(slopes, Line { offset: slice.nearest - offset, factor: -factor });
    }
    let nearness = slice.ramp(line);
    painter.paint(slice.columns(slopes), 0, |x| nearness.from(x));
}

/// Paints a plane that parallel rays meet at -q = `line / steepness`.
///
/// Seen nearly edge on it passes from the eye to the horizon within a few columns: the line is divided
/// only where it has to be between near and far, so that no quotient is too large.
fn paint_parallel<S: Scalar, O: Observer>(
    line: Line<S>,
    steepness: S,
    slice: &Slice<S>,
    painter: &mut Painter<'_, S, O>,
) {
    if steepness == S::ZERO {
        return;
    }
    let Line { offset, factor } = line;
    let [nearest, farthest] = [slice.nearest, slice.farthest].map(|nearness| nearness * steepness);
    let slopes = slice.positive(slice.window(), Line { offset: nearest - offset, factor: -factor });
    let slopes = slice.positive(slopes, Line { offset: offset - farthest, factor });
    let (height, step) = (slice.ramp(line), slice.step(factor, steepness));
    painter.paint(slice.columns(slopes), 0, |x| {
        let first = height.from(x).next().unwrap_or(S::ZERO).ratio(steepness);
        stepped(first, step)
    });
}
