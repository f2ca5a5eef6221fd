//! Shapes of a scene file.
//!
//! To add one: a variant, and an arm in each of the two functions; the compiler asks for the arms.

use super::value::{Point, point};
use crate::scenes::HostNumber;
use scanray::{Cuboid, Plane, Sphere, Triangle};
use serde::{Deserialize, Serialize};

/// Is a shape; its fields are those of the core's shape of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Shape {
    /// A ball.
    Sphere {
        /// Middle of the ball.
        center: Point,
        /// Distance of the surface from it, above 0.
        radius: f64,
    },
    /// An endless plane.
    Plane {
        /// Any point of the plane.
        point: Point,
        /// A vector across it, of any length but zero.
        normal: Point,
    },
    /// A triangle, seen from both sides.
    Triangle {
        /// First corner.
        a: Point,
        /// Second corner.
        b: Point,
        /// Third corner.
        c: Point,
    },
    /// A box along the axes.
    Cuboid {
        /// Corner with the lowest coordinates.
        low: Point,
        /// Corner with the highest coordinates.
        high: Point,
    },
}

impl Shape {
    /// Makes the core's shape, rounded to a number.
    pub fn in_number<S: HostNumber>(&self) -> scanray::Shape<S> {
        match *self {
            Self::Sphere { center, radius } => {
                scanray::Shape::Sphere(Sphere::new(point(center), S::round(radius)))
            }
            Self::Plane { point: of, normal } => scanray::Shape::Plane(Plane::new(point(of), point(normal))),
            Self::Triangle { a, b, c } => {
                scanray::Shape::Triangle(Triangle::new(point(a), point(b), point(c)))
            }
            Self::Cuboid { low, high } => scanray::Shape::Cuboid(Cuboid::new(point(low), point(high))),
        }
    }

    /// Takes a shape of the core; `None` for one that scene files do not know.
    pub fn of(shape: &scanray::Shape<f64>) -> Option<Self> {
        Some(match shape {
            scanray::Shape::Sphere(s) => Self::Sphere { center: s.center.to_array(), radius: s.radius },
            scanray::Shape::Plane(s) => {
                Self::Plane { point: s.point.to_array(), normal: s.normal.to_array() }
            }
            scanray::Shape::Triangle(s) => {
                Self::Triangle { a: s.a.to_array(), b: s.b.to_array(), c: s.c.to_array() }
            }
            scanray::Shape::Cuboid(s) => Self::Cuboid { low: s.low.to_array(), high: s.high.to_array() },
            scanray::Shape::Custom(none) => match *none {},
        })
    }
}
