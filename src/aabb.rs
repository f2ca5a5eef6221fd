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

    /// Makes the smallest box around some points; around none, that of the origin alone.
    pub fn around(points: &[Vec3<S>]) -> Self {
        let first = points.first().copied().unwrap_or(Vec3::ZERO);
        let low = |a: Vec3<S>, b: &Vec3<S>| Vec3::new(a.x.min(b.x), a.y.min(b.y), a.z.min(b.z));
        let high = |a: Vec3<S>, b: &Vec3<S>| Vec3::new(a.x.max(b.x), a.y.max(b.y), a.z.max(b.z));
        Self::between(points.iter().fold(first, low), points.iter().fold(first, high))
    }

    /// Answers how far the box reaches from its center along a unit direction.
    pub fn reach(&self, direction: Vec3<S>) -> S {
        direction.x.abs() * self.half.x + direction.y.abs() * self.half.y + direction.z.abs() * self.half.z
    }
}
