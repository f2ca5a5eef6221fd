use super::departure::Departure;
use super::lane::{LANES, Lane};
use super::observer::{Observer, RayKind};
use super::shade::{Shader, Site};
use super::vicinity::Vicinities;
use super::visibility::{Candidates, arrive, nearest};
use crate::color::Rgb;
use crate::hit::Surface;
use crate::light::Light;
use crate::material::{Material, Model};
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};
use crate::scene::Scene;
use crate::shape::{Intersect, dispatch};

/// Is a handful of rays that are traced together, and the light that comes along each.
#[derive(Clone, Debug)]
pub struct Packet<S: Scalar> {
    lanes: [Lane<S>; LANES],
    light: [Rgb<S>; LANES],
}

impl<S: Scalar> Packet<S> {
    /// Makes a packet of no rays.
    pub const fn new() -> Self {
        Self { lanes: [Lane::IDLE; LANES], light: [Rgb::BLACK; LANES] }
    }
}

impl<S: Scalar> Default for Packet<S> {
    fn default() -> Self {
        Self::new()
    }
}

/// Traces rays through a scene.
///
/// Mirrors are followed level by level: a mirror sends on one ray, which takes the place of the
/// one that met it, so that no ray ever waits and none is dropped.
pub struct Tracer<'a, 's, S: Scalar, X> {
    scene: &'s Scene<'a, S, X>,
    shader: Shader<'a, 's, S, X>,
    depth: u8,
    /// Whether any light is a spot.
    spots: bool,
    exposure: Rgb<S>,
    /// Whether the exposure is any but 1.
    exposed: bool,
    faint: S,
    eye: Option<Vec3<S>>,
}

impl<'a, 's, S: Scalar, X: Intersect<S>> Tracer<'a, 's, S, X> {
    /// Makes a tracer that follows mirrors up to `depth` times and asks every object about every
    /// shadow.
    pub fn new(scene: &'s Scene<'a, S, X>, depth: u8) -> Self {
        let shader = Shader { scene, vicinities: None };
        let spots = scene.lights.iter().any(|light| matches!(light, Light::Spot(_)));
        Self { scene, shader, depth, spots, exposure: Rgb::WHITE, exposed: false, faint: S::ZERO, eye: None }
    }

    /// Sets the factor on all light.
    pub fn with_exposure(mut self, exposure: S) -> Self {
        self.exposure = Rgb::gray(exposure);
        self.exposed = exposure != S::ONE;
        self
    }

    /// Leaves out rays of which no more than this share of their light reaches the eye.
    pub fn with_faintest(mut self, share: S) -> Self {
        self.faint = share;
        self
    }

    /// Remembers from pixel to pixel what can stand in the light.
    pub fn with_vicinities(mut self, vicinities: &'s mut Vicinities<S>) -> Self {
        self.shader.vicinities = Some(vicinities);
        self
    }

    /// Says that all primary rays start at one point.
    pub fn with_eye(mut self, eye: Option<Vec3<S>>) -> Self {
        self.eye = eye;
        self
    }

    /// Answers the light that comes along some primary rays, linear, of any magnitude; of more
    /// rays than [`LANES`] the first.
    ///
    /// `candidates` names the objects these rays may meet; whatever bounces meets all of them.
    pub fn radiance<'p>(
        &mut self,
        packet: &'p mut Packet<S>,
        rays: impl Iterator<Item = (Ray<S>, Interval<S>)>,
        candidates: Candidates<'_>,
        observer: &mut impl Observer,
    ) -> &'p [Rgb<S>] {
        let Packet { lanes, light } = packet;
        let mut count = 0;
        for (lane, (ray, interval)) in lanes.iter_mut().zip(rays) {
            (lane.ray, lane.interval) = (ray, interval);
            (lane.met, lane.from, lane.number) = (Lane::<S>::NOTHING, Departure::NOWHERE, count);
            count += 1;
            observer.ray(RayKind::Primary);
        }
        let (lanes, _) = lanes.split_at_mut(usize::from(count));
        let (light, _) = light.split_at_mut(usize::from(count));
        nearest(self.scene, candidates, self.eye, lanes);
        self.follow(lanes, light, observer);
        light
    }

    /// Lights what the rays have met and sends them on from mirrors, until none is left.
    fn follow(&mut self, mut lanes: &mut [Lane<S>], light: &mut [Rgb<S>], observer: &mut impl Observer) {
        let mut sent_on = self.light_up(0, lanes, light, observer);
        let mut level = 0;
        while sent_on {
            level += 1;
            let going = gather(lanes, self.faint);
            lanes = lanes.split_at_mut(going).0;
            lanes.iter().for_each(|_| observer.ray(RayKind::Reflection));
            self.seek_mirrored(lanes);
            sent_on = self.light_up(level, lanes, light, observer);
        }
    }

    /// Finds what mirrored rays meet, which may be any object.
    fn seek_mirrored(&self, lanes: &mut [Lane<S>]) {
        nearest(self.scene, Candidates::all(self.scene), None, lanes);
    }

    /// Adds to `light` what comes from where the rays have arrived, turns them to where they go on
    /// and tells whether any does.
    fn light_up(
        &mut self,
        level: u8,
        lanes: &mut [Lane<S>],
        light: &mut [Rgb<S>],
        observer: &mut impl Observer,
    ) -> bool {
        let mut sent_on = false;
        for run in lanes.chunk_by_mut(|a, b| a.met == b.met) {
            let met = run.first().map_or(Lane::<S>::NOTHING, |lane| lane.met);
            let object = self.scene.objects.get(usize::from(met));
            let found = object.and_then(|object| {
                Some((&object.shape, self.scene.materials.get(usize::from(object.material))?))
            });
            let Some((shape, material)) = found else {
                run.iter().for_each(|lane| observer.met(lane.number, Lane::<S>::NOTHING, 0));
                self.see_sky(level, run, light);
                continue;
            };
            sent_on |= material.mirror > S::ZERO && level < self.depth;
            let eye = if level == 0 { self.eye } else { None };
            dispatch!(shape, shape => arrive(shape, eye, run));
            if !self.spots && matches!(material.model, Model::Flat | Model::Phong) {
                self.visit::<true>(shape.is_convex(), material, level, run, light, observer);
            } else {
                self.visit_any(shape.is_convex(), material, level, run, light, observer);
            }
        }
        sent_on
    }

    fn see_sky(&self, level: u8, lanes: &mut [Lane<S>], light: &mut [Rgb<S>]) {
        for lane in lanes {
            let sent = self.scene.sky.color(lane.ray.direction);
            self.add(level, lane, sent, light);
            lane.weight = Rgb::BLACK;
        }
    }

    /// Lights places of an object of any model under any light, apart from the plain ones' path.
    #[cold]
    #[inline(never)]
    fn visit_any(
        &mut self,
        convex: bool,
        material: &Material<S>,
        level: u8,
        lanes: &mut [Lane<S>],
        light: &mut [Rgb<S>],
        observer: &mut impl Observer,
    ) {
        self.visit::<false>(convex, material, level, lanes, light, observer);
    }

    /// Lights places of one object, convex or not, all `PLAIN` or not, and reflects the rays that have reached them.
    #[inline(always)]
    fn visit<const PLAIN: bool>(
        &mut self,
        convex: bool,
        material: &Material<S>,
        level: u8,
        lanes: &mut [Lane<S>],
        light: &mut [Rgb<S>],
        observer: &mut impl Observer,
    ) {
        let reflects = material.mirror > S::ZERO && level < self.depth;
        let ambient = self.scene.ambient * material.ambient;
        for lane in lanes {
            let direction = lane.ray.direction;
            let mut surface = lane.surface();
            let outside = surface.normal.dot(direction) <= S::ZERO;
            if !outside {
                surface.normal = -surface.normal;
            }
            let from = Departure { index: lane.met, free: outside && convex };
            observer.met(lane.number, lane.met, tile(material, &surface));
            let (distance, number) = (lane.interval.far, lane.number);
            let site = Site { surface, material, ambient, direction, distance, from, level, lane: number };
            let sent = self.shader.direct::<PLAIN>(&site, observer);
            self.add(level, lane, sent, light);
            if reflects {
                lane.ray.direction = unit_reflection(direction, surface.normal);
                (lane.interval, lane.met, lane.from) = (Interval::AHEAD, Lane::<S>::NOTHING, from);
                lane.weight = if level == 0 { self.exposure } else { lane.weight } * material.mirror;
            } else {
                lane.weight = Rgb::BLACK;
            }
        }
    }

    /// Adds what a lane's surface or sky sends, as far as it reaches the eye; of what is seen
    /// directly all does, but for the exposure.
    fn add(&self, level: u8, lane: &Lane<S>, sent: Rgb<S>, light: &mut [Rgb<S>]) {
        let Some(light) = light.get_mut(usize::from(lane.number)) else { return };
        if level > 0 {
            *light += lane.weight * sent;
        } else {
            *light = if self.exposed { self.exposure * sent } else { sent };
        }
    }
}

/// Answers a number of the part and the tile that a place belongs to.
fn tile<S: Scalar>(material: &Material<S>, surface: &Surface<S>) -> u32 {
    material.texture.tile(surface) ^ u32::from(surface.part).rotate_right(3)
}

/// Answers the mirror direction, of unit length again so that rounding does not grow from bounce
/// to bounce.
fn unit_reflection<S: Scalar>(direction: Vec3<S>, normal: Vec3<S>) -> Vec3<S> {
    let mirrored = direction.reflect(normal);
    mirrored.normalize().map_or(mirrored, |(unit, _)| unit)
}

/// Moves the lanes whose weight is more than `faint` to the front and answers how many they are.
fn gather<S: Scalar>(lanes: &mut [Lane<S>], faint: S) -> usize {
    let mut going = 0;
    for at in 0..lanes.len() {
        if lanes.get(at).is_some_and(|lane| lane.weight.max() > faint) {
            if at != going {
                lanes.swap(at, going);
            }
            going += 1;
        }
    }
    going
}
