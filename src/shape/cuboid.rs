use super::Intersect;
use crate::aabb::Aabb;
use crate::fault::Fault;
use crate::hit::{Crossing, Surface, Tangent};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};

/// Is a box along the axes: the points with every coordinate between those of two corners.
///
/// Each axis gives a slab of distances; the ray is inside from the last slab entered to the first
/// one left (Kay and Kajiya 1986; row O3). Parts are the faces: 0 low x, 1 high x, 2 low y, 3 high
/// y, 4 low z, 5 high z. Texture coordinates run from 0 to 1 over a face along its two axes in
/// order. One extent may be 0: that is a rectangle seen from both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid<S = f32> {
    /// Corner with the lowest coordinates.
    pub low: Vec3<S>,
    /// Corner with the highest coordinates.
    pub high: Vec3<S>,
}

impl<S> Cuboid<S> {
    /// Makes a box of the corners with the lowest and the highest coordinates.
    pub const fn new(low: Vec3<S>, high: Vec3<S>) -> Self {
        Self { low, high }
    }
}

/// Is where a ray enters and leaves, and through which face.
struct Passage<S> {
    enter: (S, u16),
    leave: (S, u16),
}

impl<S: Scalar> Cuboid<S> {
    fn passage(&self, ray: &Ray<S>) -> Option<Passage<S>> {
        let (low, high) = (self.low.to_array(), self.high.to_array());
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        let mut passage = Passage { enter: (-S::FAR, 0), leave: (S::FAR, 0) };
        let mut face = 0;
        for ((low, high), (o, d)) in low.into_iter().zip(high).zip(origin.into_iter().zip(direction)) {
            if d == S::ZERO {
                // Along the slab: a ray in the face itself counts as inside.
                if o < low || o > high {
                    return None;
                }
            } else {
                // Divided, not multiplied by 1/d: of a slope below 1/2048 fixed point has no reciprocal.
                let distance = |level: S| (level - o).ratio(d);
                let (to_low, to_high) = (distance(low), distance(high));
                let (first, last) = if d > S::ZERO {
                    ((to_low, face), (to_high, face + 1))
                } else {
                    ((to_high, face + 1), (to_low, face))
                };
                if first.0 > passage.enter.0 {
                    passage.enter = first;
                }
                if last.0 < passage.leave.0 {
                    passage.leave = last;
                }
            }
            face += 2;
        }
        (passage.enter.0 <= passage.leave.0).then_some(passage)
    }

    /// Answers the plane coordinate of a face.
    fn level(&self, face: u16) -> S {
        match face {
            0 => self.low.x,
            1 => self.high.x,
            2 => self.low.y,
            3 => self.high.y,
            4 => self.low.z,
            _ => self.high.z,
        }
    }
}

/// Answers a coordinate's place between two others, from 0 to below 1.
fn share<S: Scalar>(p: S, low: S, high: S) -> S {
    // A rounding beyond the rim would be a tile too far.
    (p - low).ratio(high - low).max(S::ZERO).min(S::BELOW_ONE)
}

fn crossing<S: Scalar>((t, part): (S, u16)) -> Crossing<S> {
    Crossing { t, part, u: S::ZERO, v: S::ZERO }
}

impl<S: Scalar> Intersect<S> for Cuboid<S> {
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let Passage { enter, leave } = self.passage(ray)?;
        if interval.contains(enter.0) {
            Some(crossing(enter))
        } else if interval.contains(leave.0) {
            Some(crossing(leave))
        } else {
            None
        }
    }

    /// From the surface outward the box is behind; inward the ray leaves it at its far face.
    fn intersect_leaving(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        // `surface` puts the start exactly into its face, so that a way out through it has length 0.
        let leave = self.passage(ray)?.leave;
        interval.contains(leave.0).then(|| crossing(leave))
    }

    fn surface(&self, ray: &Ray<S>, found: &Crossing<S>) -> Surface<S> {
        let mut point = ray.at(found.t);
        let outward = if found.part & 1 == 1 { S::ONE } else { -S::ONE };
        let mut normal = Vec3::ZERO;
        let level = self.level(found.part);
        match found.part {
            0 | 1 => (point.x, normal.x) = (level, outward),
            2 | 3 => (point.y, normal.y) = (level, outward),
            _ => (point.z, normal.z) = (level, outward),
        }
        let Self { low, high } = self;
        let x = || share(point.x, low.x, high.x);
        let y = || share(point.y, low.y, high.y);
        let z = || share(point.z, low.z, high.z);
        let (u, v) = match found.part {
            0 | 1 => (y(), z()),
            2 | 3 => (x(), z()),
            _ => (x(), y()),
        };
        Surface { point, normal, u, v, part: found.part }
    }

    /// Along the two axes of the face, in order, its whole extent to a unit.
    fn tangents(&self, surface: &Surface<S>) -> [Tangent<S>; 2] {
        let along = |direction: Vec3<S>, length: S| Tangent { direction, length };
        let extent = self.high - self.low;
        let x = along(Vec3::new(S::ONE, S::ZERO, S::ZERO), extent.x);
        let y = along(Vec3::new(S::ZERO, S::ONE, S::ZERO), extent.y);
        let z = along(Vec3::new(S::ZERO, S::ZERO, S::ONE), extent.z);
        match surface.part {
            0 | 1 => [y, z],
            2 | 3 => [x, z],
            _ => [x, y],
        }
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn hull(&self) -> Hull<S> {
        Hull::Box(Aabb::between(self.low, self.high))
    }

    fn check(&self) -> Result<(), Fault> {
        if !(self.low.in_range() && self.high.in_range()) {
            return Err(Fault::OutOfRange);
        }
        let extents = (self.high - self.low).to_array();
        if extents.iter().any(|extent| *extent < S::ZERO) {
            Err(Fault::CornersSwapped)
        } else if extents.iter().filter(|extent| **extent == S::ZERO).count() > 1 {
            Err(Fault::Degenerate)
        } else {
            Ok(())
        }
    }
}
