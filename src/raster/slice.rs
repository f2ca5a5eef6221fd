//! The plane of a row, in which balls are discs and faces are lines, and what is seen of it.

use crate::camera::{Fan, Frame};
use crate::math::{Scalar, Vec3, Wide};
use crate::ray::Ray;
use core::ops::Range;

/// Is how near the nearest visible thing is at most, as the buffer holds it: half of what fixed point can.
const LARGEST: i32 = 1024;

/// Is a value that grows evenly with the slope of a row's rays: `offset + factor slope`.
#[derive(Clone, Copy)]
pub(super) struct Line<S> {
    pub offset: S,
    pub factor: S,
}

/// Is the plane through the eye and a row of pixels.
///
/// In it a point lies p along the row and q toward the scene. A perspective camera sees it at the slope
/// p / q, a parallel one at p. Its nearness is `scale / q`, and of parallel rays -q: either grows evenly
/// with the slope along anything flat, and is larger nearer to the eye.
pub(super) struct Slice<S: Scalar> {
    pub fan: Fan<S>,
    /// Nearness at q = 1.
    pub scale: S,
    /// Before this q nothing is seen.
    near: S,
    /// From this nearness on the camera's near plane hides what there is; [`Scalar::FAR`] without one.
    pub nearest: S,
    /// Up to this nearness its far plane does.
    pub farthest: S,
    /// Cosine of the angle between the line of sight and the plane's q axis.
    tilt: S,
}

impl<S: Scalar> Slice<S> {
    /// Makes the plane of row `y`; `clear` is a distance from the eye within which nothing stands.
    ///
    /// `None` for a window too narrow for its number. Called, not inlined, as [`super::figure::paint`] is.
    #[inline(never)]
    pub fn of(frame: &Frame<S>, y: u32, clear: S) -> Option<Self> {
        let fan = frame.row_fan(y)?;
        if fan.parallel {
            let (nearest, farthest) = (-frame.near, -frame.far);
            return Some(Self { fan, scale: S::ONE, near: frame.near, nearest, farthest, tilt: S::ONE });
        }
        let tilt = fan.toward.dot(frame.forward);
        let along_q = |depth: S| depth.ratio(tilt);
        // Off the q axis the same distance is a smaller q.
        let [left, right] = [fan.start, fan.start + fan.extent].map(S::abs);
        let longest = Vec3::new(S::ONE, left.max(right), S::ZERO).length();
        let large = S::from_i32(LARGEST);
        let nearest_q = clear.ratio(longest).min(S::ONE).max(large.recip());
        let scale = nearest_q * large;
        let hides = frame.near > S::ZERO;
        Some(Self {
            fan,
            scale,
            near: nearest_q.max(along_q(frame.near)),
            nearest: if hides { scale.ratio(along_q(frame.near)) } else { S::FAR },
            farthest: scale.ratio(if frame.far < S::FAR { along_q(frame.far) } else { S::FAR }),
            tilt,
        })
    }

    /// Is the slope itself.
    pub const SLOPE: Line<S> = Line { offset: S::ZERO, factor: S::ONE };

    /// Answers the slope of one of the row's rays.
    pub fn slope(&self, ray: &Ray<S>) -> S {
        if self.fan.parallel {
            (ray.origin - self.fan.apex).dot(self.fan.along)
        } else {
            S::div(ray.direction.dot_wide(self.fan.along), ray.direction.dot_wide(self.fan.toward))
        }
    }

    /// Answers the slopes at the left and the right edge of the window.
    pub fn window(&self) -> [S; 2] {
        [self.fan.start, self.fan.start + self.fan.extent]
    }

    /// Answers the columns whose middles lie from one slope to below another.
    pub fn columns(&self, [low, high]: [S; 2]) -> Range<u32> {
        let Fan { start, extent, count, .. } = self.fan;
        let first = |slope: S| {
            let place = (slope - start).ratio(extent).mul_wide(S::ONE).scale(count, 1);
            // Rounded up: the middle of column x lies half a column beyond x.
            let column = S::floor(S::HALF.mul_wide(S::ONE) - place).saturating_neg();
            column.min(count).max(0) as u32
        };
        first(low)..first(high)
    }

    /// Answers the part of some slopes in which a line is not below zero.
    pub fn positive(&self, [low, high]: [S; 2], Line { offset, factor }: Line<S>) -> [S; 2] {
        let zero = -offset.ratio(factor);
        if factor > S::ZERO {
            [low.max(zero), high]
        } else if factor < S::ZERO {
            [low, high.min(zero)]
        } else if offset < S::ZERO {
            [high, low]
        } else {
            [low, high]
        }
    }

    /// Follows a line from column to column.
    pub fn ramp(&self, Line { offset, factor }: Line<S>) -> Ramp<S> {
        let Fan { start, extent, count, .. } = self.fan;
        let extent = factor.mul_wide(extent);
        let left = offset.mul_wide(S::ONE) + factor.mul_wide(start);
        Ramp { left, extent, step: extent.scale(1, count), count }
    }

    /// Answers what a nearness changes from one column to the next, where it changes by `rise` over `run`
    /// slopes.
    pub fn step(&self, rise: S, run: S) -> S {
        S::div(rise.mul_wide(self.fan.extent).scale(1, self.fan.count), run.mul_wide(S::ONE))
    }

    /// Answers the nearness of a q.
    pub fn nearness(&self, q: S) -> S {
        if self.fan.parallel { -q } else { self.scale.ratio(q) }
    }

    /// Answers how far along its ray a hit of some nearness is; `length` is that of a depth of 1 along it.
    pub fn distance(&self, nearness: S, length: S) -> S {
        if self.fan.parallel {
            -nearness
        } else {
            S::div((self.scale * self.tilt).mul_wide(length), nearness.mul_wide(S::ONE))
        }
    }

    /// Clips a piece of a line by the near plane and the sides of the window; points begin with p and q.
    pub fn clip<const N: usize>(&self, mut ends: [[S; N]; 2]) -> Option<[[S; N]; 2]> {
        let [left, right] = self.window();
        let side = |p: S, q: S, edge: S| {
            let q = if self.fan.parallel { S::ONE } else { q };
            p.mul_wide(S::ONE) - edge.mul_wide(q)
        };
        ends = cut(ends, |_, q| (q - self.near).mul_wide(S::ONE))?;
        ends = cut(ends, |p, q| side(p, q, left))?;
        cut(ends, |p, q| -side(p, q, right))
    }
}

/// Leaves of a piece of a line what lies where `height` is not below zero.
fn cut<S: Scalar, const N: usize>(
    [a, b]: [[S; N]; 2],
    height: impl Fn(S, S) -> S::Wide,
) -> Option<[[S; N]; 2]> {
    let above = |point: &[S; N]| match point.as_slice() {
        [p, q, ..] => height(*p, *q),
        _ => S::Wide::ZERO,
    };
    let (of_a, of_b) = (above(&a), above(&b));
    match (of_a < S::Wide::ZERO, of_b < S::Wide::ZERO) {
        (false, false) => Some([a, b]),
        (true, true) => None,
        (true, false) => Some([between(&b, &a, S::div(of_b, of_b - of_a)), b]),
        (false, true) => Some([a, between(&a, &b, S::div(of_a, of_a - of_b))]),
    }
}

/// Answers the point at a share of the way; its rounding is one along the line, which does no harm.
fn between<S: Scalar, const N: usize>(from: &[S; N], to: &[S; N], share: S) -> [S; N] {
    let mut point = *from;
    for (at, to) in point.iter_mut().zip(to) {
        *at = at.add_product(*to - *at, share);
    }
    point
}

/// Is a line on its way along a row.
pub(super) struct Ramp<S: Scalar> {
    left: S::Wide,
    extent: S::Wide,
    step: S::Wide,
    count: i32,
}

impl<S: Scalar> Ramp<S> {
    /// Answers the values from the middle of column `x` on.
    pub fn from(&self, x: u32) -> impl Iterator<Item = S> + use<S> {
        // The double of a column's number fits.
        let middle = i32::try_from(x.wrapping_mul(2).wrapping_add(1)).unwrap_or(i32::MAX);
        let (mut at, step) = (self.left + self.extent.scale(middle, self.count.wrapping_mul(2)), self.step);
        core::iter::repeat_with(move || {
            let value = S::narrow(at);
            at = at + step;
            value
        })
    }
}
