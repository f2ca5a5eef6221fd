use super::Intersect;
use crate::fault::Fault;
use crate::hit::{Crossing, Surface, Tangent};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3, Wide};
use crate::ray::{Interval, Ray};

/// Is a triangle, seen from both sides: the points `a + u (b - a) + v (c - a)` with `u`, `v` and
/// `1 - u - v` in [0, 1]; u and v are its texture coordinates.
///
/// In floats the test is that of Möller and Trumbore (1997; row O2): with edges e, f and s = o - a, the
/// determinant `e.(d x f)` divides `s.(d x f)` into u and `s.(e x d)` into v.
///
/// In fixed point these products of three lengths do not fit, and one that is rounded between lets rays through at
/// edges. There corners are seen along the ray (Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection"):
/// with z the axis along which the ray goes farthest and p a corner as seen from its origin, the corner is at
/// `(p_x d_z - p_z d_x, p_y d_z - p_z d_y)` around the ray, which is rounded alike in every triangle that has it. The
/// areas between the ray and the edges, `a_x b_y - a_y b_x`, are exact, and 0 or of one sign in a triangle that is
/// met; of two that share an edge, both see the same area with opposite signs: no ray slips through between them.
///
/// Either way the distance is that of the point u and v name.
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

impl<S: Scalar> Triangle<S> {
    /// Answers u and v where the line of a ray passes, by determinants of three vectors.
    #[inline(always)]
    fn by_determinants(&self, ray: &Ray<S>) -> Option<(S, S)> {
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
        Some((S::div(u, determinant), S::div(v, determinant)))
    }

    /// Answers u and v where the line of a ray passes, by the areas between it and the edges as seen along it.
    #[inline(always)]
    fn between_edges(&self, ray: &Ray<S>) -> Option<(S, S)> {
        let turn = Turn::of(ray.direction);
        let direction = turn.turned(ray.direction);
        let corners = [self.a, self.b, self.c].map(|corner| turn.turned(corner - ray.origin));
        let [ax, bx, cx] = corners.map(|p| S::determinant([p.x, p.z], [direction.x, direction.z]));
        // A miss that shows already saves 12 of 18 products.
        if on_one_side(ax, bx, cx) {
            return None;
        }
        let [ay, by, cy] = corners.map(|p| S::determinant([p.y, p.z], [direction.y, direction.z]));
        if on_one_side(ay, by, cy) {
            return None;
        }
        // Each corner's share is the area across from it.
        let area = |px: S, py: S, qx: S, qy: S| px.mul_wide(qy) - py.mul_wide(qx);
        let (u, v) = (area(cx, cy, ax, ay), area(ax, ay, bx, by));
        if opposed(u, v) {
            return None;
        }
        let (w, rest) = (area(bx, by, cx, cy), u + v);
        // Both signs are a hit: one from each side.
        if opposed(w, rest) {
            return None;
        }
        let whole = w + rest;
        (whole != S::Wide::ZERO).then(|| (S::div(u, whole), S::div(v, whole)))
    }
}

/// Names the axis that turns into the third one.
#[derive(Clone, Copy)]
enum Turn {
    X,
    Y,
    Z,
}

impl Turn {
    /// Finds the axis along which a direction goes farthest.
    #[inline(always)]
    fn of<S: Scalar>(direction: Vec3<S>) -> Self {
        let [x, y, z] = direction.to_array().map(S::abs);
        if z >= x && z >= y {
            Self::Z
        } else if y >= x {
            Self::Y
        } else {
            Self::X
        }
    }

    /// Answers a vector whose third component is that along the axis.
    #[inline(always)]
    fn turned<S>(self, Vec3 { x, y, z }: Vec3<S>) -> Vec3<S> {
        match self {
            Self::X => Vec3::new(y, z, x),
            Self::Y => Vec3::new(z, x, y),
            Self::Z => Vec3::new(x, y, z),
        }
    }
}

/// Tells whether one of two numbers is above 0 and the other below.
#[inline(always)]
fn opposed<W: Wide>(p: W, q: W) -> bool {
    (p < W::ZERO && q > W::ZERO) || (p > W::ZERO && q < W::ZERO)
}

/// Tells whether three numbers are all above 0, or all below.
#[inline(always)]
fn on_one_side<S: Scalar>(a: S, b: S, c: S) -> bool {
    (a > S::ZERO && b > S::ZERO && c > S::ZERO) || (a < S::ZERO && b < S::ZERO && c < S::ZERO)
}

impl<S: Scalar> Intersect<S> for Triangle<S> {
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let (u, v) = if S::EXACT_PRODUCTS { self.between_edges(ray) } else { self.by_determinants(ray) }?;
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
