//! How far from the eye the nearest surface may be: it says how finely depths are told apart.
//!
//! A z-buffer spends most of its numbers near the eye, and in fixed point there are 2^31 of them. Nearness
//! is therefore measured so that it is about 1024 where the first thing can be.

use crate::aabb::Aabb;
use crate::math::{Scalar, Vec3};
use crate::shape::{Cuboid, Plane, Sphere, Triangle};

/// Answers the distance of an eye from a ball's surface.
pub(super) fn of_ball<S: Scalar>(ball: &Sphere<S>, eye: Vec3<S>) -> S {
    ((ball.center - eye).length() - ball.radius).abs()
}

/// Answers the distance of an eye from a plane.
pub(super) fn of_plane<S: Scalar>(plane: &Plane<S>, eye: Vec3<S>) -> S {
    plane.normal.normalize().map_or(S::ZERO, |(normal, _)| (plane.point - eye).dot(normal).abs())
}

/// Answers a distance from an eye within which there is nothing of a triangle: that of its plane or of
/// its bounds.
pub(super) fn of_triangle<S: Scalar>(triangle: &Triangle<S>, eye: Vec3<S>) -> S {
    let Triangle { a, b, c } = *triangle;
    let unit = |edge: Vec3<S>| edge.normalize().map_or(Vec3::ZERO, |(unit, _)| unit);
    let plane = Plane::new(a, unit(b - a).cross(unit(c - a)));
    of_plane(&plane, eye).max(outside(&Aabb::around(&[a, b, c]), eye))
}

/// Answers the distance of an eye from the faces of a box.
pub(super) fn of_box<S: Scalar>(cuboid: &Cuboid<S>, eye: Vec3<S>) -> S {
    let bounds = Aabb::between(cuboid.low, cuboid.high);
    let depths = (eye - bounds.center).to_array().into_iter().zip(bounds.half.to_array());
    let inside = depths.map(|(off, half)| half - off.abs()).fold(S::FAR, S::min);
    outside(&bounds, eye).max(inside)
}

/// Answers the distance of an eye from a box it is outside of; 0 inside.
fn outside<S: Scalar>(bounds: &Aabb<S>, eye: Vec3<S>) -> S {
    let Vec3 { x, y, z } = eye - bounds.center;
    let beyond = |off: S, half: S| (off.abs() - half).max(S::ZERO);
    Vec3::new(beyond(x, bounds.half.x), beyond(y, bounds.half.y), beyond(z, bounds.half.z)).length()
}
