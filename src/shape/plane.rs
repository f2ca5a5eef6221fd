use super::Intersect;
use crate::fault::Fault;
use crate::hit::{Crossing, Surface, Tangent};
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

/// Names the axis that a plane lies across, if it lies across one.
#[derive(Clone, Copy)]
enum Across {
    X,
    Y,
    Z,
    None,
}

impl<S: Scalar> Plane<S> {
    /// Most planes of a scene are floors and walls: to meet one takes a division, to stand on it no
    /// product and no root.
    fn across(&self) -> Across {
        let Vec3 { x, y, z } = self.normal;
        match (x == S::ZERO, y == S::ZERO, z == S::ZERO) {
            (false, true, true) => Across::X,
            (true, false, true) => Across::Y,
            (true, true, false) => Across::Z,
            _ => Across::None,
        }
    }

    /// Answers how far a ray goes until it meets the plane.
    fn distance(&self, ray: &Ray<S>) -> Option<S> {
        let Vec3 { x, y, z } = ray.direction;
        let way = self.point - ray.origin;
        let (height, slope) = match self.across() {
            Across::X => (way.x, x),
            Across::Y => (way.y, y),
            Across::Z => (way.z, z),
            Across::None => {
                let slope = ray.direction.dot_wide(self.normal);
                return (slope != S::Wide::ZERO).then(|| S::div(way.dot_wide(self.normal), slope));
            }
        };
        (slope != S::ZERO).then(|| height.ratio(slope))
    }
}

/// Answers 1 with the sign of a number.
fn sign<S: Scalar>(n: S) -> S {
    if n < S::ZERO { -S::ONE } else { S::ONE }
}

/// Answers the two coordinates of a point that a plane of this normal does not hide.
pub(super) fn flatten<S: Scalar>(point: Vec3<S>, normal: Vec3<S>) -> (S, S) {
    let (x, y, z) = (normal.x.abs(), normal.y.abs(), normal.z.abs());
    if y >= x && y >= z {
        (point.x, point.z)
    } else if x >= z {
        (point.y, point.z)
    } else {
        (point.x, point.y)
    }
}

/// Answers the ways along which the coordinates of [`flatten`] grow on a plane of a unit normal.
///
/// One coordinate of the world grows, one stays, and the hidden one follows: `n.(dp) = 0`.
#[inline(never)]
pub(super) fn tangents<S: Scalar>(normal: Vec3<S>) -> [Tangent<S>; 2] {
    let Vec3 { x: a, y: b, z: c } = normal;
    let (x, y, z) = (a.abs(), b.abs(), c.abs());
    let along = |x, y, z| Tangent::along(Vec3::new(x, y, z));
    if y >= x && y >= z {
        [along(S::ONE, -a.ratio(b), S::ZERO), along(S::ZERO, -c.ratio(b), S::ONE)]
    } else if x >= z {
        [along(-b.ratio(a), S::ONE, S::ZERO), along(-c.ratio(a), S::ZERO, S::ONE)]
    } else {
        [along(S::ONE, S::ZERO, -a.ratio(c)), along(S::ZERO, S::ONE, -b.ratio(c))]
    }
}

impl<S: Scalar> Intersect<S> for Plane<S> {
    // Asked in a loop over rays: what does not change from ray to ray is to stay in registers.
    #[inline(always)]
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let t = self.distance(ray)?;
        interval.contains(t).then_some(Crossing::at(t))
    }

    /// A ray that starts on a plane never meets it again.
    fn intersect_leaving(&self, _: &Ray<S>, _: &Interval<S>) -> Option<Crossing<S>> {
        None
    }

    // A call in each pixel costs 15 instructions and more.
    #[inline(always)]
    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        let mut point = ray.at(crossing.t);
        let Vec3 { x, y, z } = self.normal;
        let mut normal = Vec3::ZERO;
        let (u, v) = match self.across() {
            Across::X => {
                (point.x, normal.x) = (self.point.x, sign(x));
                (point.y, point.z)
            }
            Across::Y => {
                (point.y, normal.y) = (self.point.y, sign(y));
                (point.x, point.z)
            }
            Across::Z => {
                (point.z, normal.z) = (self.point.z, sign(z));
                (point.x, point.y)
            }
            Across::None => {
                normal = self.normal.normalize().map_or(-ray.direction, |(unit, _)| unit);
                point = point.add_scaled(normal, (self.point - point).dot(normal));
                flatten(point, normal)
            }
        };
        Surface { point, normal, u, v, part: 0 }
    }

    fn is_convex(&self) -> bool {
        true
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
