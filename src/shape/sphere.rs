use super::Intersect;
use crate::fault::Fault;
use crate::hit::{Crossing, Surface, Tangent};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3, Wide, turns};
use crate::ray::{Interval, Ray};

/// Is a ball: the points with `|p - center| = radius`.
///
/// With `b = d.(c - o)` and `h^2 = r^2 - |(c - o) - b d|^2` a ray of unit direction crosses it at
/// `b - h` and `b + h` (the form of Haines, Günther and Akenine-Möller 2019, in *Ray Tracing Gems*,
/// that does not subtract two large squares; row O1).
///
/// Texture coordinates are `u = 1 - phi / 2 pi` and `v = 1 - theta / pi` (row T1), where
/// `tan phi = z / x` and `tan theta = sqrt(x^2 + z^2) / y` for the normal (x, y, z): v runs from the
/// pole at low y to that at high y, u eastward, so that an image reads right from outside.
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
    /// Answers the two distances at which a ray's line crosses the ball.
    pub(super) fn chord(&self, ray: &Ray<S>) -> Option<[S; 2]> {
        let to_center = self.center - ray.origin;
        let b = to_center.dot(ray.direction);
        let square = if b >= S::FAR { None } else { self.square_of_half_chord(ray, to_center, b) };
        let h = S::sqrt(square?);
        Some([b - h, b + h])
    }

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

/// Answers the texture coordinates of a direction from the middle of a ball, of unit length: from 0 to
/// below 1.
#[inline(never)]
pub(super) fn coordinates<S: Scalar>(direction: Vec3<S>) -> [S; 2] {
    let Vec3 { x, y, z } = direction;
    let from_axis = S::sqrt(x.mul_wide(x) + z.mul_wide(z));
    // Theta in turns is at most 1/2.
    let theta = turns(from_axis, y);
    [S::ONE - turns(z, x), S::ONE - (theta + theta)].map(|share| share.min(S::BELOW_ONE))
}

/// Answers the ways along which the texture coordinates grow at a direction from the middle, so far
/// out: `dp/du` is `2 pi r (z, 0, -x)`, `dp/dv` is `pi r` toward the upper pole.
#[inline(never)]
pub(super) fn tangents<S: Scalar>(direction: Vec3<S>, radius: S) -> [Tangent<S>; 2] {
    let Vec3 { x, z, .. } = direction;
    let half_circle = S::PI * radius;
    let east = Tangent::along(Vec3::new(z, S::ZERO, -x));
    let length = (half_circle + half_circle) * east.length;
    let north = direction.cross(east.direction);
    [Tangent { length, ..east }, Tangent { direction: north, length: half_circle }]
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

    fn texture_coordinates(&self, surface: &Surface<S>) -> [S; 2] {
        coordinates(surface.normal)
    }

    /// In fixed point lengths end at 2048: bumps on balls of a radius above 326 come out too steep.
    fn tangents(&self, surface: &Surface<S>) -> [Tangent<S>; 2] {
        tangents(surface.normal, self.radius)
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
