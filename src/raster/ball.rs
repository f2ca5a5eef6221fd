//! Balls: in the plane of a row a disc, whose nearness is a conic of the slope.
//!
//! A disc with its middle at (p, q) and of radius r is met at `w = 1/q` where
//! `c w^2 - 2 b w + 1 + s^2 = 0`, with `c = p^2 + q^2 - r^2` the power of the eye and `b = s p + q`.
//! Of the roots `(b + h) / c` and `(b - h) / c` the first is the nearer one. h is zero at the slopes of
//! the two tangents, so that h^2 is the product of two lines: with (u, v) the unit vector to the middle,
//! m = sqrt(c) the length of the tangents and t = r / m,
//!
//! ```text
//! (h / m)^2 = (t (s u + v) - (u - s v)) (t (s u + v) + (u - s v))
//! ```
//!
//! No large squares are subtracted, and where both factors are positive is where the disc is seen.

use super::depths::Painter;
use super::slice::{Line, Slice};
use crate::math::{Scalar, Vec3, Wide};
use crate::shape::Sphere;
use crate::trace::Observer;

/// Puts a ball into the row of depths.
pub(super) fn paint<S: Scalar, O: Observer>(
    ball: &Sphere<S>,
    slice: &Slice<S>,
    painter: &mut Painter<'_, S, O>,
) {
    let [p, q, off] = slice.fan.place(ball.center);
    let square = ball.radius.mul_wide(ball.radius) - off.mul_wide(off);
    if square < S::Wide::ZERO {
        return;
    }
    let disc = Disc { middle: [p, q], radius: S::sqrt(square) };
    if slice.fan.parallel {
        return disc.parallel().paint(slice, painter);
    }
    let distance = (ball.center - slice.fan.apex).length();
    let power = (distance - ball.radius).mul_wide(distance + ball.radius);
    // At the very surface the tangents have no length, and no number has room for what they divide.
    let tangent = S::sqrt(power.abs()).max(S::PARALLEL);
    if distance > ball.radius {
        disc.perspective(slice.scale, tangent).paint(slice, painter);
    } else {
        disc.around(slice, tangent, painter);
    }
}

/// Is what the plane of a row cuts out of a ball.
struct Disc<S> {
    middle: [S; 2],
    radius: S,
}

/// Is the nearness of a disc: `scale (middle + sqrt(left right))`.
struct Conic<S> {
    left: Line<S>,
    right: Line<S>,
    middle: Line<S>,
    scale: S,
}

impl<S: Scalar> Disc<S> {
    /// Answers the conic of parallel rays, `-q + sqrt(r^2 - (s - p)^2)`.
    fn parallel(&self) -> Conic<S> {
        let ([p, q], radius) = (self.middle, self.radius);
        Conic {
            left: Line { offset: radius - p, factor: S::ONE },
            right: Line { offset: radius + p, factor: -S::ONE },
            middle: Line { offset: -q, factor: S::ZERO },
            scale: S::ONE,
        }
    }

    /// Answers the conic seen by an eye outside, from which the tangents have a length.
    fn perspective(&self, scale: S, tangent: S) -> Conic<S> {
        let (u, v, distance) = self.direction();
        let (wide, far) = (self.radius.ratio(tangent), distance.ratio(tangent));
        Conic {
            left: Line { offset: wide * v - u, factor: wide * u + v },
            right: Line { offset: wide * v + u, factor: wide * u - v },
            middle: Line { offset: far * v, factor: far * u },
            scale: scale.ratio(tangent),
        }
    }

    /// Answers the unit vector to the middle, and how far it is.
    fn direction(&self) -> (S, S, S) {
        let [p, q] = self.middle;
        S::normalize([p, q, S::ZERO]).map_or((S::ZERO, S::ZERO, S::ZERO), |([u, v, _], d)| (u, v, d))
    }

    /// Paints the disc around an eye inside it, in every column: there c is -m^2, and the root ahead is
    /// `(sqrt(b^2 + m^2 (1 + s^2)) - b) / m^2`.
    fn around<O: Observer>(&self, slice: &Slice<S>, tangent: S, painter: &mut Painter<'_, S, O>) {
        let [p, q] = self.middle.map(|length| length.ratio(tangent));
        let (slopes, middle) = (slice.ramp(Slice::SLOPE), slice.ramp(Line { offset: q, factor: p }));
        let (scale, nearest) = (slice.scale.ratio(tangent), slice.nearest);
        painter.paint(slice.columns(slice.window()), 0, |x| {
            slopes.from(x).zip(middle.from(x)).map(move |(slope, b)| {
                let vector = Vec3::new(b, slope, S::ONE);
                let nearness = scale * (S::sqrt(vector.dot_wide(vector)) - b);
                hidden_from(nearest, nearness)
            })
        });
    }
}

impl<S: Scalar> Conic<S> {
    fn paint<O: Observer>(&self, slice: &Slice<S>, painter: &mut Painter<'_, S, O>) {
        let seen = slice.positive(slice.positive(slice.window(), self.left), self.right);
        let [left, right, middle] = [self.left, self.right, self.middle].map(|line| slice.ramp(line));
        let (scale, nearest) = (self.scale, slice.nearest);
        painter.paint(slice.columns(seen), 0, |x| {
            left.from(x).zip(right.from(x)).zip(middle.from(x)).map(move |((left, right), middle)| {
                let half = S::sqrt(left.mul_wide(right));
                let front = scale * (middle + half);
                // Where the near plane cuts the ball open its far side is seen from within.
                if front < nearest { front } else { hidden_from(nearest, scale * (middle - half)) }
            })
        });
    }
}

/// Answers a nearness, or where the near plane hides it one that no pixel keeps.
fn hidden_from<S: Scalar>(nearest: S, nearness: S) -> S {
    if nearness < nearest { nearness } else { S::FAR_BACK }
}
