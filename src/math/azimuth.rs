use super::Scalar;

/// Holds what a number needs to find angles: polynomial and centre are of its own precision.
#[derive(Clone, Copy, Debug)]
pub struct Arctangent<S: 'static> {
    /// Is the tangent of a sixteenth of a turn, `sqrt(2) - 1`.
    pub sixteenth: S,
    /// Holds `1 / 2 pi`, `-1 / 6 pi`, `1 / 10 pi` ...: the first terms of the series of the arctangent.
    pub series: &'static [S],
}

/// Answers the terms of `atan(x) / (2 pi x) = (1 - x^2 / 3 + x^4 / 5 - ...) / 2 pi` (Gregory 1671).
pub(super) const fn series<const TERMS: usize>() -> [f64; TERMS] {
    let mut terms = [0.0; TERMS];
    let mut k = 0;
    while k < TERMS {
        let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        terms[k] = sign / (core::f64::consts::TAU * (2 * k + 1) as f64);
        k += 1;
    }
    terms
}

/// Answers the angle of the point (x, y) in turns, anticlockwise from the first axis, 0 to 1.
///
/// The point lies near the unit circle: of points farther out than 200 fixed point saturates. The
/// error is at most 3e-6 in fixed point, 2e-7 in `f32` and 4e-16 in `f64`; the origin has the angle 0.
pub fn turns<S: Scalar>(y: S, x: S) -> S {
    let quarter = S::HALF * S::HALF;
    let (across, up) = (x.abs(), y.abs());
    let angle = if up > across { quarter - octant(across, up) } else { octant(up, across) };
    let angle = if x < S::ZERO { S::HALF - angle } else { angle };
    if y < S::ZERO { S::ONE - angle } else { angle }
}

/// Answers the angle whose tangent is `small / large`, at most 1, in turns.
///
/// It is measured from the nearest of the angles 0, 1/16 and 1/8: with their tangent c the rest has
/// the tangent `(small - c large) / (large + c small)`, which is at most 1/5, so that each term of the
/// series counts 1/25 of the one before.
fn octant<S: Scalar>(small: S, large: S) -> S {
    if large == S::ZERO {
        return S::ZERO;
    }
    let times = |n: i32, value: S| S::from_i32(n) * value;
    let eighth = S::HALF * S::HALF * S::HALF;
    let (center, tangent) = if times(5, small) < large {
        (S::ZERO, small.ratio(large))
    } else if times(3, small) > times(2, large) {
        (eighth, (small - large).ratio(large + small))
    } else {
        let c = S::ARCTANGENT.sixteenth;
        (eighth * S::HALF, (small - c * large).ratio(large + c * small))
    };
    let square = tangent * tangent;
    let sum = S::ARCTANGENT.series.iter().rev().fold(S::ZERO, |sum, term| *term + square * sum);
    center + tangent * sum
}
