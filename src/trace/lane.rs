use super::departure::Departure;
use crate::color::Rgb;
use crate::hit::{Crossing, Surface};
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};

/// Is how many rays are traced together.
///
/// An object is looked up once for all of them and asked in one loop, so that what it needs stays
/// in registers.
pub const LANES: usize = 8;

/// Is a ray on its way through a scene, with the nearest it has met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lane<S = f32> {
    pub ray: Ray<S>,
    /// Where it looks: up to the nearest crossing found.
    pub interval: Interval<S>,
    /// Texture coordinates and part of that crossing.
    pub u: S,
    pub v: S,
    pub part: u16,
    /// The nearest object met, or [`Lane::NOTHING`].
    pub met: u16,
    /// The surface the ray starts on.
    pub from: Departure,
    /// Which of the rays traced together it is.
    pub number: u8,
    /// What of its light reaches the eye.
    pub weight: Rgb<S>,
    /// Outward normal of the surface reached; the ray then starts on that surface.
    pub normal: Vec3<S>,
}

impl<S: Scalar> Lane<S> {
    /// Stands for no object.
    pub const NOTHING: u16 = u16::MAX;

    /// Is a lane that no ray has taken yet.
    pub const IDLE: Self = Self {
        ray: Ray::new(Vec3::ZERO, Vec3::ZERO),
        interval: Interval::new(S::ZERO, S::ZERO),
        u: S::ZERO,
        v: S::ZERO,
        part: 0,
        met: 0,
        from: Departure::UNSET,
        number: 0,
        weight: Rgb::BLACK,
        normal: Vec3::ZERO,
    };

    /// Takes note of a crossing nearer than those before.
    pub fn meet(&mut self, index: u16, crossing: Crossing<S>) {
        let Crossing { t, part, u, v } = crossing;
        (self.interval.far, self.part, self.u, self.v) = (t, part, u, v);
        self.met = index;
    }

    /// Goes onto the surface at the nearest crossing.
    pub fn arrive(&mut self, surface: Surface<S>) {
        (self.ray.origin, self.normal) = (surface.point, surface.normal);
        (self.u, self.v, self.part) = (surface.u, surface.v, surface.part);
    }

    /// Tells whether the lane stands on glass, where its ray splits.
    pub fn splits(&self) -> bool {
        self.met != Self::NOTHING && self.weight.is_lit()
    }

    /// Sends the lane on along a ray from the surface reached.
    pub fn go_on(&mut self, ray: Ray<S>, from: Departure, weight: Rgb<S>) {
        (self.ray, self.from, self.weight) = (ray, from, weight);
        (self.interval, self.met) = (Interval::AHEAD, Self::NOTHING);
    }

    /// Answers the surface reached.
    pub fn surface(&self) -> Surface<S> {
        Surface { point: self.ray.origin, normal: self.normal, u: self.u, v: self.v, part: self.part }
    }

    /// Answers the nearest crossing found.
    pub fn crossing(&self) -> Crossing<S> {
        Crossing { t: self.interval.far, part: self.part, u: self.u, v: self.v }
    }
}
