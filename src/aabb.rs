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
        let (mut low, mut high) = (first, first);
        for point in points {
            stretch(&mut low, &mut high, point);
        }
        Self::between(low, high)
    }

    /// Answers how far the box reaches from its center along a unit direction.
    pub fn reach(&self, direction: Vec3<S>) -> S {
        direction.x.abs() * self.half.x + direction.y.abs() * self.half.y + direction.z.abs() * self.half.z
    }
}

/// Moves two opposite corners apart until a point is between them. Called, not inlined: unrolled, the
/// loop around it takes 1 KB of a Cortex-M3's flash.
#[inline(never)]
fn stretch<S: Scalar>(low: &mut Vec3<S>, high: &mut Vec3<S>, point: &Vec3<S>) {
    *low = Vec3::new(low.x.min(point.x), low.y.min(point.y), low.z.min(point.z));
    *high = Vec3::new(high.x.max(point.x), high.y.max(point.y), high.z.max(point.z));
}
