//! The simple convex set that holds a shape: what is asked before the shape itself is.

use crate::aabb::Aabb;
use crate::math::{Scalar, Vec3};

/// Is a convex set that holds a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Hull<S = f32> {
    /// A ball.
    Ball {
        /// Middle of the ball.
        center: Vec3<S>,
        /// Distance of the surface from it, at least 0.
        radius: S,
    },
    /// A box along the axes.
    Box(Aabb<S>),
    /// A triangle.
    Triangle([Vec3<S>; 3]),
    /// An endless plane.
    Plane {
        /// Any point of the plane.
        point: Vec3<S>,
        /// A vector across it, of any length but zero.
        normal: Vec3<S>,
    },
    /// All of space: nothing is known of the shape.
    Everything,
}

impl<S: Scalar> Hull<S> {
    /// Answers the box along the axes around the set; `None` where it has no end.
    pub fn bounds(&self) -> Option<Aabb<S>> {
        match *self {
            Self::Ball { center, radius } => Some(Aabb { center, half: Vec3::new(radius, radius, radius) }),
            Self::Box(bounds) => Some(bounds),
            Self::Triangle(corners) => Some(Aabb::around(&corners)),
            Self::Plane { .. } | Self::Everything => None,
        }
    }
}
