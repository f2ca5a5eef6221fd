use super::Intersect;
use crate::fault::Fault;
use crate::hit::{Crossing, Surface};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3, Wide};
use crate::ray::{Interval, Ray};

/// Is an endless plane: the points with `(p - point).normal = 0`.
///
/// A ray crosses it at `t = (point - o).normal / d.normal` (row O5). Texture coordinates are the
/// two world coordinates other than the one along the largest component of the normal.
///
/// Nothing is met beyond [`Scalar::FAR`]: in fixed point a plane ends 2048 units away, for the eye
/// (at its horizon) and for shadow rays that nearly run along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<S = f32> {
    /// Any point of the plane.
    pub point: Vec3<S>,
    /// A vector across it, of any length but zero.
    pub normal: Vec3<S>,
}

impl<S> Plane<S> {
    /// Makes a plane through a point, across a vector of any length.
    pub const fn new(point: Vec3<S>, normal: Vec3<S>) -> Self {
        Self { point, normal }
    }
}

impl<S: Scalar> Plane<S> {
    /// Answers the normal with unit length; most planes have it so.
    fn unit_normal(&self) -> Option<Vec3<S>> {
        if self.normal.dot_wide(self.normal) == S::ONE.mul_wide(S::ONE) {
            return Some(self.normal);
        }
        Some(self.normal.normalize()?.0)
    }
}

/// Answers the two coordinates of a point that a plane of this normal does not hide.
fn flatten<S: Scalar>(point: Vec3<S>, normal: Vec3<S>) -> (S, S) {
    let (x, y, z) = (normal.x.abs(), normal.y.abs(), normal.z.abs());
    if y >= x && y >= z {
        (point.x, point.z)
    } else if x >= z {
        (point.y, point.z)
    } else {
        (point.x, point.y)
    }
}

impl<S: Scalar> Intersect<S> for Plane<S> {
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let slope = ray.direction.dot_wide(self.normal);
        if slope == S::Wide::ZERO {
            return None;
        }
        let t = S::div((self.point - ray.origin).dot_wide(self.normal), slope);
        interval.contains(t).then_some(Crossing::at(t))
    }

    /// A ray that starts on a plane never meets it again.
    fn intersect_leaving(&self, _: &Ray<S>, _: &Interval<S>) -> Option<Crossing<S>> {
        None
    }

    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        let normal = self.unit_normal().unwrap_or(-ray.direction);
        let rough = ray.at(crossing.t);
        let point = rough + normal * (self.point - rough).dot(normal);
        let (u, v) = flatten(point, self.normal);
        Surface { point, normal, u, v, part: 0 }
    }

    fn hull(&self) -> Hull<S> {
        Hull::Plane { point: self.point, normal: self.normal }
    }

    fn check(&self) -> Result<(), Fault> {
        if !(self.point.in_range() && self.normal.in_range()) {
            Err(Fault::OutOfRange)
        } else if self.normal.normalize().is_none() {
            Err(Fault::NoDirection)
        } else {
            Ok(())
        }
    }
}
