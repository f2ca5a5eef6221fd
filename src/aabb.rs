//! The box along the axes that holds a shape.

use crate::math::{Scalar, Vec3};

/// Is a box along the axes that holds a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb<S = f32> {
    /// Middle of the box.
    pub center: Vec3<S>,
    /// Half of its extent along each axis, at least 0.
    pub half: Vec3<S>,
}

impl<S: Scalar> Aabb<S> {
    /// Makes the box between two opposite corners.
    pub fn between(a: Vec3<S>, b: Vec3<S>) -> Self {
        let half = (b - a) * S::HALF;
        Self { center: a + half, half: Vec3::new(half.x.abs(), half.y.abs(), half.z.abs()) }
    }

    /// Makes the smallest box around three points.
    pub fn around(points: [Vec3<S>; 3]) -> Self {
        let [a, b, c] = points;
        let low = |a: S, b: S, c: S| a.min(b).min(c);
        let high = |a: S, b: S, c: S| a.max(b).max(c);
        Self::between(
            Vec3::new(low(a.x, b.x, c.x), low(a.y, b.y, c.y), low(a.z, b.z, c.z)),
            Vec3::new(high(a.x, b.x, c.x), high(a.y, b.y, c.y), high(a.z, b.z, c.z)),
        )
    }

    /// Answers how far the box reaches from its center along a unit direction.
    pub fn reach(&self, direction: Vec3<S>) -> S {
        direction.x.abs() * self.half.x + direction.y.abs() * self.half.y + direction.z.abs() * self.half.z
    }
}
