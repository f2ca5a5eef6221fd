use super::march::{Bracket, bracket};
use super::{Intersect, Sphere, sphere};
use crate::fault::Fault;
use crate::hit::{Crossing, Surface, Tangent};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};
use crate::texture::{Image, Spot, bend, levels, rise};

/// Is a ball whose points are moved outward by a map of heights: `|p - center| = radius + height h(u, v)`
/// (Cook 1984; row T3).
///
/// The map lies over the ball as a texture does; h runs from 0, where it is black, to 1 at its full green
/// level, and is smoothed between texels. Outline and shadow are those of the moved points. The normal is
/// that of heights averaged over a texel, so that light does not break at the texels' rims.
///
/// A ray walks through the shell between the ball and the highest relief in steps of 1/96 of the outer
/// radius, at most 193 of them, and then halves the step that went through the surface to the last digit:
/// what is thinner than a step along the ray may be missed. Each step finds two angles and four texels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Displaced<S = f32> {
    /// The ball, where the map is black.
    pub ball: Sphere<S>,
    /// The map of heights; its filter does not matter.
    pub relief: Image<S>,
    /// How far out the map's full green level moves a point, at least 0.
    pub height: S,
}

impl<S> Displaced<S> {
    /// Makes a ball with a relief of at most so much height.
    pub const fn new(ball: Sphere<S>, relief: Image<S>, height: S) -> Self {
        Self { ball, relief, height }
    }
}

/// Is how many steps a radius is walked through in.
const STEPS_A_RADIUS: i32 = 96;

impl<S: Scalar> Displaced<S> {
    fn hull_ball(&self) -> Sphere<S> {
        Sphere::new(self.ball.center, self.ball.radius + self.height)
    }

    /// Answers how far out the surface lies at a place of the map.
    fn radius_at(&self, spot: &Spot<S>) -> S {
        let share = levels(&self.relief.bitmap, spot).g.ratio(S::from_i32(255));
        self.ball.radius.add_product(self.height, share)
    }

    fn is_inside(&self, point: Vec3<S>) -> bool {
        let Some((direction, distance)) = (point - self.ball.center).normalize() else { return true };
        if distance <= self.ball.radius {
            return true;
        }
        let [u, v] = sphere::coordinates(direction);
        distance < self.radius_at(&self.relief.spot(u, v))
    }

    /// Finds the step of a ray that first crosses the surface inside the interval.
    fn step_across(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Bracket<S>> {
        let outer = self.hull_ball();
        let [enter, leave] = outer.chord(ray)?;
        let near = enter.max(interval.near);
        let inside = |t: S| self.is_inside(ray.at(t));
        // Where a peak touches the hull a rounding must not turn the ray inside out.
        let from_inside = enter < interval.near && inside(near);
        let step = outer.radius.ratio(S::from_i32(STEPS_A_RADIUS));
        bracket([near, leave.min(interval.far)], step, from_inside, inside)
    }
}

impl<S: Scalar> Intersect<S> for Displaced<S> {
    #[inline(never)]
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let step = self.step_across(ray, interval)?;
        // The side the ray comes from is kept in place of a coordinate.
        let u = if step.from_inside { S::ONE } else { S::ZERO };
        let t = step.narrow(|t| self.is_inside(ray.at(t)));
        interval.contains(t).then_some(Crossing { u, ..Crossing::at(t) })
    }

    #[inline(never)]
    fn occludes(&self, ray: &Ray<S>, interval: &Interval<S>) -> bool {
        self.step_across(ray, interval).is_some()
    }

    #[inline(never)]
    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        let rough = ray.at(crossing.t) - self.ball.center;
        let (direction, _) = rough.normalize().unwrap_or((-ray.direction, S::ZERO));
        let [u, v] = sphere::coordinates(direction);
        let spot = self.relief.spot(u, v);
        let radius = self.radius_at(&spot);
        let tangents = sphere::tangents(direction, radius);
        let slopes = rise(&self.relief, &spot, self.height, &tangents);
        let normal = bend(direction, &tangents, slopes);
        // Near the outline an averaged normal may look away from a viewer who sees the surface.
        let away = (normal.dot(ray.direction) > S::ZERO) != (crossing.u > S::ZERO);
        let normal = if away { normal.reflect(ray.direction) } else { normal };
        // Neighbouring texels count as parts: their light differs.
        let part = self.relief.tile(u, v);
        let part = (part ^ part >> 16) as u16;
        Surface { point: self.ball.center.add_scaled(direction, radius), normal, u, v, part }
    }

    fn tangents(&self, surface: &Surface<S>) -> [Tangent<S>; 2] {
        let from_center = (surface.point - self.ball.center).normalize();
        let (direction, radius) = from_center.unwrap_or((surface.normal, self.ball.radius));
        sphere::tangents(direction, radius)
    }

    fn hull(&self) -> Hull<S> {
        Sphere::hull(&self.hull_ball())
    }

    fn check(&self) -> Result<(), Fault> {
        self.hull_ball().check()?;
        if !(self.relief.in_range() && self.height >= S::ZERO) {
            Err(Fault::OutOfRange)
        } else if !self.relief.bitmap.fits() {
            Err(Fault::ImageSize)
        } else {
            self.ball.check()
        }
    }
}
