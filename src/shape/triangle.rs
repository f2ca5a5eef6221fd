use super::Intersect;
use crate::fault::Fault;
use crate::hit::{Crossing, Surface, Tangent};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3, Wide};
use crate::ray::{Interval, Ray};

/// Is a triangle, seen from both sides: the points `a + u (b - a) + v (c - a)` with `u`, `v` and
/// `1 - u - v` in [0, 1]; u and v are its texture coordinates.
///
/// The test is that of Möller and Trumbore (1997; row O2): with edges e, f and s = o - a, the
/// determinant `e.(d x f)` divides `s.(d x f)` into u and `s.(e x d)` into v. The distance is
/// that of the point u and v name, so no product of three lengths has to fit the number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle<S = f32> {
    /// First corner, u = v = 0.
    pub a: Vec3<S>,
    /// Second corner, u = 1.
    pub b: Vec3<S>,
    /// Third corner, v = 1. The outward side is the one from which a, b, c run anticlockwise.
    pub c: Vec3<S>,
}

impl<S> Triangle<S> {
    /// Makes a triangle of its corners.
    pub const fn new(a: Vec3<S>, b: Vec3<S>, c: Vec3<S>) -> Self {
        Self { a, b, c }
    }
}

impl<S: Scalar> Triangle<S> {
    fn edges(&self) -> (Vec3<S>, Vec3<S>) {
        (self.b - self.a, self.c - self.a)
    }

    /// Answers the unit normal; `None` when the corners lie on a line.
    pub(super) fn normal(&self) -> Option<Vec3<S>> {
        // Unit edges first: the product of two long ones would not fit a fixed-point number.
        let (e, f) = self.edges();
        let (e, f) = (e.normalize()?.0, f.normalize()?.0);
        let (normal, sine) = e.cross(f).normalize()?;
        (sine > S::PARALLEL).then_some(normal)
    }

    /// Answers the point of barycentric coordinates.
    pub(super) fn point(&self, u: S, v: S) -> Vec3<S> {
        let (e, f) = self.edges();
        self.a + e * u + f * v
    }
}

impl<S: Scalar> Intersect<S> for Triangle<S> {
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let (e, f) = self.edges();
        let p = ray.direction.cross(f);
        let determinant = e.dot_wide(p);
        if determinant == S::Wide::ZERO {
            return None;
        }
        // Both signs of the determinant are a hit: one from each side.
        let back = determinant < S::Wide::ZERO;
        let ahead = |share: S::Wide| if back { -share } else { share };
        let determinant = ahead(determinant);
        // A little beyond each edge, so that no ray slips through between two triangles: 1/65536.
        let slack = determinant.scale(1, 1 << 16);
        let from_corner = ray.origin - self.a;
        let u = ahead(from_corner.dot_wide(p));
        // What misses by this coordinate is known to: 9 of 21 products are saved.
        if u < -slack || u > determinant + slack + slack {
            return None;
        }
        let v = ahead(from_corner.dot_wide(e.cross(ray.direction)));
        if v < -slack || u + v > determinant + slack {
            return None;
        }
        let (u, v) = (S::div(u, determinant), S::div(v, determinant));
        let t = (self.point(u, v) - ray.origin).dot(ray.direction);
        interval.contains(t).then_some(Crossing { t, part: 0, u, v })
    }

    /// A ray that starts on a triangle never meets it again.
    fn intersect_leaving(&self, _: &Ray<S>, _: &Interval<S>) -> Option<Crossing<S>> {
        None
    }

    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        Surface {
            point: self.point(crossing.u, crossing.v),
            normal: self.normal().unwrap_or(-ray.direction),
            u: crossing.u,
            v: crossing.v,
            part: 0,
        }
    }

    /// Along the edges from the first corner, each a unit long.
    fn tangents(&self, _: &Surface<S>) -> [Tangent<S>; 2] {
        let (e, f) = self.edges();
        [Tangent::along(e), Tangent::along(f)]
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn hull(&self) -> Hull<S> {
        Hull::Triangle([self.a, self.b, self.c])
    }

    fn check(&self) -> Result<(), Fault> {
        if !(self.a.in_range() && self.b.in_range() && self.c.in_range()) {
            Err(Fault::OutOfRange)
        } else if self.normal().is_none() {
            Err(Fault::Degenerate)
        } else {
            Ok(())
        }
    }
}
