mod frame;
mod hyperbola;

use super::Intersect;
use super::called::{add_scaled, add_scaled_nearest, difference, dot, normalized, product_nearest, scaled};
use crate::aabb::Aabb;
use crate::fault::Fault;
use crate::hit::{Crossing, Surface, Tangent};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};
use frame::{Frame, Passage, SIDE};

/// Is a cone, a cone whose tip is cut off, or a cylinder: what a radius that changes evenly sweeps
/// on the way from one point to another.
///
/// With z along the axis from its middle, c and g the cosine and the sine of the angle at which the
/// radius grows, and w = c (radius at z), the side is `c^2 (x^2 + y^2) = w^2`, where w is linear in z.
/// With x along what the axis leaves of the ray's direction, y is constant, and (c x, w) runs along
/// a line: measured in steps of that line's length, the crossings solve a quadratic whose numbers
/// are no larger than the cone (derived from the hyperbola that a plane along the axis cuts out; row
/// O9, as in Haines's Neutral File Format). The solid is where the ray is between its side and its
/// ends at once, as in a [`Cuboid`](super::Cuboid): no ray slips through at a rim.
///
/// Parts are 0 the side, 1 the cap at the base, 2 the cap at the apex. Texture coordinate u is one turn
/// around the axis, eastward as on a [`Sphere`](super::Sphere) with its upper pole at the apex; it begins
/// on the side of x, or of y where the axis lies along x more than along y and along z. v runs from 0 at
/// the base to 1 at the apex. Over a cap both go on as they are at its rim: it shows the rim's colours to
/// its middle, and takes no bumps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone<S = f32> {
    /// Middle of one end.
    pub base: Vec3<S>,
    /// Radius there, at least 0.
    pub base_radius: S,
    /// Middle of the other end.
    pub apex: Vec3<S>,
    /// Radius there, at least 0; one of the two is above 0.
    pub apex_radius: S,
    /// Whether discs close the ends; else one looks through, and sees the inside.
    pub capped: bool,
}

impl<S> Cone<S> {
    /// Makes a solid cone of the middles and radii of its ends.
    pub const fn new(base: Vec3<S>, base_radius: S, apex: Vec3<S>, apex_radius: S) -> Self {
        Self { base, base_radius, apex, apex_radius, capped: true }
    }

    /// Makes a solid cylinder of the middles of its ends and its radius.
    pub const fn cylinder(base: Vec3<S>, apex: Vec3<S>, radius: S) -> Self
    where
        S: Copy,
    {
        Self::new(base, radius, apex, radius)
    }

    /// Takes the caps off both ends.
    pub const fn open(mut self) -> Self {
        self.capped = false;
        self
    }
}

impl<S: Scalar> Cone<S> {
    /// Answers half of the way from the base to the apex: in fixed point all of it may not fit.
    fn half(&self) -> Vec3<S> {
        scaled(difference(self.apex, self.base), S::HALF)
    }

    /// Answers the cone's own measure; `None` when base and apex coincide.
    fn frame(&self) -> Option<Frame<S>> {
        let (axis, half) = normalized(self.half())?;
        let growth = (self.apex_radius - self.base_radius) * S::HALF;
        let ([cosine, sine, _], _) = S::normalize([half, growth, S::ZERO])?;
        let width = product_nearest(self.base_radius + growth, cosine);
        Some(Frame { middle: self.base + self.half(), axis, half, slant: [cosine, sine], width })
    }

    /// Answers how far a disc of radius 1 across the axis reaches along each of the world's axes; `None` when base
    /// and apex coincide.
    #[inline(never)]
    fn reach_across(&self) -> Option<Vec3<S>> {
        self.frame().map(|frame| frame.reach_across())
    }

    /// Answers where a ray enters and leaves the solid.
    #[inline(never)]
    fn passage(&self, ray: &Ray<S>) -> Option<Passage<S>> {
        let half = self.half();
        let from_middle = difference(difference(ray.origin, self.base), half);
        let ahead = -dot(from_middle, ray.direction);
        let near = add_scaled_nearest(from_middle, ray.direction, ahead);
        // Most rays miss the ball around it: they cost no root. Saturated, it is farther than anything.
        let radius = self.base_radius.max(self.apex_radius);
        let ball = half.dot_wide(half) + radius.mul_wide(radius);
        if ahead.abs() >= S::FAR || near.dot_wide(near) > ball {
            return None;
        }
        let frame = self.frame()?;
        let Passage { mut enter, mut leave } = frame.between_ends(near, ray.direction)?;
        let [first, last] = frame.within_side(near, ray.direction)?;
        if first > enter.0 {
            enter = (first, SIDE);
        }
        if last < leave.0 {
            leave = (last, SIDE);
        }
        let from_start = |(t, part): (S, u16)| (ahead + t, part);
        (enter.0 <= leave.0).then(|| Passage { enter: from_start(enter), leave: from_start(leave) })
    }

    /// Answers one end of a passage as a crossing, if there is something and the ray looks for it.
    fn crossing(&self, (t, part): (S, u16), interval: &Interval<S>) -> Option<Crossing<S>> {
        let there = self.capped || part == SIDE;
        (there && interval.contains(t)).then_some(Crossing { t, part, u: S::ZERO, v: S::ZERO })
    }
}

impl<S: Scalar> Intersect<S> for Cone<S> {
    #[inline(never)]
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let Passage { enter, leave } = self.passage(ray)?;
        self.crossing(enter, interval).or_else(|| self.crossing(leave, interval))
    }

    /// From the surface outward the cone is behind; inward the ray leaves it at its far side. The start is
    /// the nearer of the two crossings, whatever rounding makes of its distance 0.
    #[inline(never)]
    fn intersect_leaving(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let Passage { enter, leave } = self.passage(ray)?;
        if enter.0 + leave.0 > S::ZERO { self.crossing(leave, interval) } else { None }
    }

    #[inline(never)]
    fn surface(&self, ray: &Ray<S>, found: &Crossing<S>) -> Surface<S> {
        let (rough, part) = (ray.at(found.t), found.part);
        let Some(frame) = self.frame() else {
            return Surface { point: rough, normal: -ray.direction, u: S::ZERO, v: S::ZERO, part };
        };
        let (normal, depth) =
            frame.nearest_of(part, rough - frame.middle).unwrap_or((-ray.direction, S::ZERO));
        let point = add_scaled(rough, normal, depth);
        Surface { point, normal, u: S::ZERO, v: S::ZERO, part }
    }

    #[inline(never)]
    fn texture_coordinates(&self, surface: &Surface<S>) -> [S; 2] {
        self.frame().map_or([S::ZERO; 2], |frame| {
            let from_middle = difference(surface.point, frame.middle);
            [frame.turn(from_middle), frame.share(from_middle)]
        })
    }

    /// In fixed point lengths end at 2048: bumps on cones of a radius above 326 come out too steep.
    #[inline(never)]
    fn tangents(&self, surface: &Surface<S>) -> [Tangent<S>; 2] {
        let frame = self.frame().filter(|_| surface.part == SIDE);
        let nowhere = Tangent { direction: Vec3::ZERO, length: S::ZERO };
        frame.map_or([nowhere; 2], |frame| frame.tangents(difference(surface.point, frame.middle)))
    }

    /// Open as well: outward from its side it is not met again, and inward every crossing counts.
    fn is_convex(&self) -> bool {
        true
    }

    #[inline(never)]
    fn hull(&self) -> Hull<S> {
        let Some(around) = self.reach_across() else { return Hull::Everything };
        let rim = |end: &Vec3<S>, reach: S| add_scaled(*end, around, reach);
        Hull::Box(Aabb::around(&[
            rim(&self.base, -self.base_radius),
            rim(&self.base, self.base_radius),
            rim(&self.apex, -self.apex_radius),
            rim(&self.apex, self.apex_radius),
        ]))
    }

    #[inline(never)]
    fn check(&self) -> Result<(), Fault> {
        let radii = [self.base_radius, self.apex_radius];
        if !(self.base.in_range() && self.apex.in_range() && radii.iter().all(|radius| radius.in_range())) {
            Err(Fault::OutOfRange)
        } else if radii.iter().any(|radius| *radius < S::ZERO) || radii == [S::ZERO; 2] {
            Err(Fault::RadiusNotPositive)
        } else if self.frame().is_none() {
            Err(Fault::NoDirection)
        } else {
            Ok(())
        }
    }
}
