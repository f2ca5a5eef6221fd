use super::Intersect;
use crate::fault::Fault;
use crate::hit::{Crossing, Surface};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3, Wide};
use crate::ray::{Interval, Ray};

/// Is a ball: the points with `|p - center| = radius`.
///
/// With `b = d.(c - o)` and `h^2 = r^2 - |(c - o) - b d|^2` a ray of unit direction crosses it at
/// `b - h` and `b + h` (the form of Haines, Günther and Akenine-Möller 2019, in *Ray Tracing Gems*,
/// that does not subtract two large squares; row O1). It has no texture coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<S = f32> {
    /// Middle of the ball.
    pub center: Vec3<S>,
    /// Distance of the surface from it, above 0.
    pub radius: S,
}

impl<S> Sphere<S> {
    /// Makes a ball.
    pub const fn new(center: Vec3<S>, radius: S) -> Self {
        Self { center, radius }
    }
}

impl<S: Scalar> Sphere<S> {
    /// Answers h^2 of a ray that passes the middle at distance `b`; `None` where it misses.
    ///
    /// Most rays miss, and most of these by more than the radius along a single axis: that is seen
    /// before any square is taken.
    #[inline(always)]
    fn square_of_half_chord(&self, ray: &Ray<S>, to_center: Vec3<S>, b: S) -> Option<S::Wide> {
        let beyond = |offset: S| offset.abs() > self.radius;
        let square = || self.radius.mul_wide(self.radius);
        // From behind the middle only a ray inside the ball can meet it.
        if b < S::ZERO {
            let Vec3 { x, y, z } = to_center;
            if beyond(x) || beyond(y) || beyond(z) || to_center.dot_wide(to_center) > square() {
                return None;
            }
        }
        let x = to_center.x - ray.direction.x * b;
        if beyond(x) {
            return None;
        }
        let y = to_center.y - ray.direction.y * b;
        if beyond(y) {
            return None;
        }
        let across = Vec3::new(x, y, to_center.z - ray.direction.z * b);
        let rest = square() - across.dot_wide(across);
        (rest >= S::Wide::ZERO).then_some(rest)
    }
}

impl<S: Scalar> Intersect<S> for Sphere<S> {
    // Asked in a loop over rays: what does not change from ray to ray is to stay in registers.
    #[inline(always)]
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let to_center = self.center - ray.origin;
        let b = to_center.dot(ray.direction);
        // Saturated: the ball is farther away than anything is looked for.
        if b >= S::FAR || b - self.radius >= interval.far {
            return None;
        }
        let square = self.square_of_half_chord(ray, to_center, b)?;
        let h = S::sqrt(square);
        let (first, second) = (b - h, b + h);
        if interval.contains(first) {
            Some(Crossing::at(first))
        } else if interval.contains(second) {
            Some(Crossing::at(second))
        } else {
            None
        }
    }

    /// Asks by squares: a shadow needs no root.
    fn occludes(&self, ray: &Ray<S>, interval: &Interval<S>) -> bool {
        let to_center = self.center - ray.origin;
        let b = to_center.dot(ray.direction);
        if b >= S::FAR {
            return false;
        }
        let Some(square) = self.square_of_half_chord(ray, to_center, b) else { return false };
        // Whether b - h, or b + h, lies beyond a distance: h^2 against the square of the way to b.
        let first_beyond = |t: S| b > t && (b - t).mul_wide(b - t) > square;
        let second_beyond = |t: S| b > t || (t - b).mul_wide(t - b) < square;
        if first_beyond(interval.near) {
            !first_beyond(interval.far)
        } else {
            second_beyond(interval.near) && !second_beyond(interval.far)
        }
    }

    /// From the surface outward there is no second crossing; inward it is at `2 b`.
    fn intersect_leaving(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let b = (self.center - ray.origin).dot(ray.direction);
        let t = b + b;
        interval.contains(t).then_some(Crossing::at(t))
    }

    // A call in each pixel costs 15 instructions and more.
    #[inline(always)]
    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        let rough = ray.at(crossing.t);
        let (normal, distance) =
            (rough - self.center).normalize_near(self.radius).unwrap_or((-ray.direction, self.radius));
        Surface {
            // Moved along the normal by what rounding left: on a ball of radius 999 fixed point is
            // 4e-5 off without this and 2e-6 with it.
            point: rough + normal * (self.radius - distance),
            normal,
            u: S::ZERO,
            v: S::ZERO,
            part: 0,
        }
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn hull(&self) -> Hull<S> {
        Hull::Ball { center: self.center, radius: self.radius }
    }

    fn check(&self) -> Result<(), Fault> {
        if !(self.center.in_range() && self.radius.in_range()) {
            Err(Fault::OutOfRange)
        } else if self.radius > S::ZERO {
            Ok(())
        } else {
            Err(Fault::RadiusNotPositive)
        }
    }
}
