//! Rays and the interval in which they look.

use crate::math::{Scalar, Vec3};

/// Is a half-line in world space: the points `origin + t direction`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<S = f32> {
    /// Where the ray starts.
    pub origin: Vec3<S>,
    /// Where it goes, of unit length: `t` is a distance.
    pub direction: Vec3<S>,
}

impl<S: Scalar> Ray<S> {
    /// Makes a ray; `direction` has unit length.
    pub const fn new(origin: Vec3<S>, direction: Vec3<S>) -> Self {
        Self { origin, direction }
    }

    /// Answers the point at distance `t`.
    pub fn at(&self, t: S) -> Vec3<S> {
        self.origin.add_scaled(self.direction, t)
    }
}

/// Is the open interval of distances in which a ray looks for hits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval<S = f32> {
    /// Hits at this distance or nearer do not count.
    pub near: S,
    /// Hits at this distance or farther do not count.
    pub far: S,
}

impl<S: Scalar> Interval<S> {
    /// Is everything in front of the origin.
    pub const AHEAD: Self = Self::new(S::ZERO, S::FAR);

    /// Makes an interval of its ends.
    pub const fn new(near: S, far: S) -> Self {
        Self { near, far }
    }

    /// Tells whether a distance lies inside.
    pub fn contains(&self, t: S) -> bool {
        self.near < t && t < self.far
    }
}
