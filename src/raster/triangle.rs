use super::depths::{Fragment, Painter};
use super::slice::Slice;
use super::span::Span;
use crate::math::Scalar;
use crate::shape::Triangle;
use crate::trace::Observer;

/// Puts a triangle into the row of depths.
pub(super) fn paint<S: Scalar, O: Observer>(
    triangle: &Triangle<S>,
    slice: &Slice<S>,
    painter: &mut Painter<'_, S, O>,
) {
    let corners = [triangle.a, triangle.b, triangle.c].map(|corner| slice.fan.place(corner));
    if let Some(span) = Span::of(slice, &corners) {
        span.paint(slice, 0, painter);
    }
}

/// Knows the u and v of a triangle along a row.
pub(super) struct Coordinates<S>(Span<S, 5>);

impl<S: Scalar> Coordinates<S> {
    /// Finds them; `None` where the row does not see the triangle.
    pub fn of(triangle: &Triangle<S>, slice: &Slice<S>) -> Option<Self> {
        let corner = |corner, u, v| {
            let [p, q, off] = slice.fan.place(corner);
            [p, q, off, u, v]
        };
        let corners = [
            corner(triangle.a, S::ZERO, S::ZERO),
            corner(triangle.b, S::ONE, S::ZERO),
            corner(triangle.c, S::ZERO, S::ONE),
        ];
        Span::of(slice, &corners).map(Self)
    }

    /// Answers u and v at a slope where the triangle is as near as the fragment.
    ///
    /// Not u, but u/z grows evenly along the row: at the share f of the way between the ends, u has gone
    /// the share f z / z1 of its own, with z that of the place and z1 that of the right end.
    pub fn at(&self, slope: S, fragment: &Fragment<S>, slice: &Slice<S>) -> [S; 2] {
        let Span { left, right } = self.0;
        let even = (slope - left.slope).ratio(right.slope - left.slope);
        let share = if slice.fan.parallel {
            even
        } else {
            S::div(even.mul_wide(right.nearness), fragment.nearness.mul_wide(S::ONE))
        };
        let ([_, _, _, u0, v0], [_, _, _, u1, v1]) = (left.point, right.point);
        [u0.add_product(u1 - u0, share), v0.add_product(v1 - v0, share)]
    }
}
