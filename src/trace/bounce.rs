use super::observer::{Observer, RayKind};
use super::shade::{Site, direct};
use super::visibility::{Found, nearest};
use crate::color::Rgb;
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};
use crate::scene::Scene;
use crate::shape::Intersect;
use heapless::Vec;

/// Is a ray that waits to be traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounce<S = f32> {
    ray: Ray<S>,
    /// What of its light reaches the eye.
    weight: Rgb<S>,
    /// The object it leaves.
    leaving: u16,
    /// How many surfaces it has left.
    level: u8,
}

/// Traces rays through a scene, bounces as a loop over a stack of `DEPTH` places.
///
/// The loop goes depth first, and a surface below level `depth` sends on nothing. With mirrors a
/// surface sends on one ray, so one waits at most. Were it two, one would be taken at once and the
/// other wait, one for each level: never more than `depth` of them, and `depth <= DEPTH`.
#[derive(Debug)]
pub struct Tracer<'a, 's, S: Scalar, X, const DEPTH: usize> {
    scene: &'s Scene<'a, S, X>,
    waiting: &'s mut Vec<Bounce<S>, DEPTH>,
    depth: u8,
}

impl<'a, 's, S: Scalar, X: Intersect<S>, const DEPTH: usize> Tracer<'a, 's, S, X, DEPTH> {
    /// Makes a tracer that follows mirrors up to `depth` times, at most `DEPTH`.
    pub fn new(scene: &'s Scene<'a, S, X>, waiting: &'s mut Vec<Bounce<S>, DEPTH>, depth: u8) -> Self {
        let depth = depth.min(u8::try_from(DEPTH).unwrap_or(u8::MAX));
        Self { scene, waiting, depth }
    }

    /// Answers the light that comes along a primary ray, linear, of any magnitude.
    ///
    /// `candidates` names the objects the ray may meet; whatever bounces meets all of them.
    pub fn radiance(
        &mut self,
        ray: &Ray<S>,
        interval: &Interval<S>,
        candidates: impl Iterator<Item = u16>,
        observer: &mut impl Observer,
    ) -> Rgb<S> {
        self.waiting.clear();
        observer.ray(RayKind::Primary);
        let found = nearest(self.scene, candidates, ray, *interval, None);
        let mut sum = self.arrive(ray, found, Rgb::WHITE, 0, observer);
        while let Some(bounce) = self.waiting.pop() {
            observer.ray(RayKind::Reflection);
            let all = 0..u16::try_from(self.scene.objects.len()).unwrap_or(u16::MAX);
            let found = nearest(self.scene, all, &bounce.ray, Interval::AHEAD, Some(bounce.leaving));
            sum += self.arrive(&bounce.ray, found, bounce.weight, bounce.level, observer);
        }
        sum
    }

    /// Answers the weighted light from where a ray arrives and leaves a bounce waiting.
    fn arrive(
        &mut self,
        ray: &Ray<S>,
        found: Option<Found<'a, S, X>>,
        weight: Rgb<S>,
        level: u8,
        observer: &mut impl Observer,
    ) -> Rgb<S> {
        let Some((found, material)) = found.and_then(|found| {
            let material = self.scene.materials.get(usize::from(found.object.material))?;
            Some((found, material))
        }) else {
            return weight * self.scene.sky.color(ray.direction);
        };
        let mut surface = found.object.shape.surface(ray, &found.crossing);
        surface.normal = facing(surface.normal, ray.direction);
        if material.mirror > S::ZERO && level < self.depth {
            let bounce = Bounce {
                ray: Ray::new(surface.point, unit_reflection(ray.direction, surface.normal)),
                weight: weight * material.mirror,
                leaving: found.index,
                level: level + 1,
            };
            // The bound above says that there is room.
            let pushed = self.waiting.push(bounce);
            debug_assert!(pushed.is_ok(), "more rays wait than the depth allows");
        }
        let site = Site { surface, material, to_eye: -ray.direction, index: found.index };
        weight * direct(self.scene, &site, observer)
    }
}

/// Turns a normal to the side a travelling direction comes from.
fn facing<S: Scalar>(normal: Vec3<S>, direction: Vec3<S>) -> Vec3<S> {
    if normal.dot(direction) > S::ZERO { -normal } else { normal }
}

/// Answers the mirror direction, of unit length again so that rounding does not grow from bounce
/// to bounce.
fn unit_reflection<S: Scalar>(direction: Vec3<S>, normal: Vec3<S>) -> Vec3<S> {
    let mirrored = direction.reflect(normal);
    mirrored.normalize().map_or(mirrored, |(unit, _)| unit)
}
