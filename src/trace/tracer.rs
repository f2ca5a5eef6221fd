use super::departure::Departure;
use super::detail::refine;
use super::lane::Lane;
use super::observer::{Observer, RayKind};
use super::packet::Packet;
use super::pending::Pending;
use super::shade::{Shader, Site};
use super::step::Step;
use super::vicinity::Vicinities;
use super::visibility::{Candidates, arrive, nearest};
use crate::color::Rgb;
use crate::environment::Sky;
use crate::hit::Surface;
use crate::material::Material;
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};
use crate::scene::Scene;
use crate::shape::Intersect;
use core::hint::black_box;

/// Traces rays through a scene.
///
/// Mirrors are followed level by level: a mirror sends on one ray, which takes the place of the
/// one that met it, so that no ray waits. Where a ray meets glass it leaves the
/// others and is followed alone to the end of its tree, depth first.
pub struct Tracer<'a, 's, S: Scalar, X> {
    pub(super) scene: &'s Scene<'a, S, X>,
    shader: Shader<'a, 's, S, X>,
    /// Places for rays that wait, one a level.
    pub(super) pending: &'s mut [Pending<S>],
    pub(super) depth: u8,
    pub(super) exposure: Rgb<S>,
    /// Whether the exposure is any but 1.
    exposed: bool,
    pub(super) faint: S,
    eye: Option<Vec3<S>>,
}

impl<'a, 's, S: Scalar, X: Intersect<S>> Tracer<'a, 's, S, X> {
    /// Makes a tracer that asks every object about every shadow and follows rays through as many
    /// mirrors and surfaces of glass as there are places in `pending`, whatever they hold.
    pub fn new(scene: &'s Scene<'a, S, X>, pending: &'s mut [Pending<S>]) -> Self {
        let depth = u8::try_from(pending.len()).unwrap_or(u8::MAX);
        let shader = Shader { scene, vicinities: None };
        let (exposure, faint) = (Rgb::WHITE, S::ZERO);
        Self { scene, shader, pending, depth, exposure, exposed: false, faint, eye: None }
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

    /// Answers the light of rays that meet nothing, where it is the same in all directions.
    pub fn background(&self) -> Option<Rgb<S>> {
        match self.scene.sky {
            Sky::Solid(light) if self.scene.volume.is_none() => Some(self.exposure * light),
            _ => None,
        }
    }

    /// Answers the light that comes along some primary rays, linear, of any magnitude; of more
    /// rays than [`LANES`](super::LANES) the first.
    ///
    /// `candidates` names the objects these rays may meet; whatever bounces meets all of them.
    pub fn radiance<'p>(
        &mut self,
        packet: &'p mut Packet<S>,
        rays: impl Iterator<Item = (Ray<S>, Interval<S>)>,
        candidates: Candidates<'_>,
        observer: &mut impl Observer,
    ) -> &'p [Rgb<S>] {
        let count = packet.load(rays, &candidates, observer);
        self.radiance_of(packet, count, candidates, observer)
    }

    /// Answers the light of the rays that a packet has taken up, so many.
    pub(crate) fn radiance_of<'p>(
        &mut self,
        packet: &'p mut Packet<S>,
        count: usize,
        candidates: Candidates<'_>,
        observer: &mut impl Observer,
    ) -> &'p [Rgb<S>] {
        let Packet { lanes, light } = packet;
        // A compiler that sees that there are eight at most unrolls every loop over lanes: 1.7 KB of an M0+'s image.
        let lanes = black_box(lanes.get_mut(..count).unwrap_or_default());
        let light = light.get_mut(..count).unwrap_or_default();
        nearest(self.scene, candidates, self.eye, lanes);
        match self.scene.volume {
            Some(volume) if cfg!(feature = "volumes") => self.follow_behind(volume, lanes, light, observer),
            _ => self.follow(lanes, light, observer),
        }
        light
    }

    /// Lights what the rays have met and sends them on from mirrors, until none is left.
    pub(super) fn follow(
        &mut self,
        mut lanes: &mut [Lane<S>],
        light: &mut [Rgb<S>],
        observer: &mut impl Observer,
    ) {
        let mut onward = self.light_up(0, lanes, light, observer);
        let mut level = 0;
        loop {
            if cfg!(feature = "glass") && onward.split {
                for lane in lanes.iter_mut().filter(|lane| lane.splits()) {
                    self.follow_tree(level, lane, light, observer);
                    lane.weight = Rgb::BLACK;
                }
            }
            if !onward.mirrored {
                return;
            }
            level = level.saturating_add(1);
            let going = gather(lanes, self.faint);
            lanes = lanes.get_mut(..going).unwrap_or_default();
            lanes.iter().for_each(|_| observer.ray(RayKind::Reflection));
            self.seek_mirrored(lanes);
            onward = self.light_up(level, lanes, light, observer);
        }
    }

    /// Finds what mirrored rays meet, which may be any object.
    pub(super) fn seek_mirrored(&self, lanes: &mut [Lane<S>]) {
        nearest(self.scene, Candidates::all(self.scene), None, lanes);
    }

    /// Adds to `light` what comes from where the rays have arrived, turns those at mirrors to where they
    /// go on, leaves those at glass where they are and tells whether there are any.
    pub(super) fn light_up(
        &mut self,
        level: u8,
        lanes: &mut [Lane<S>],
        light: &mut [Rgb<S>],
        observer: &mut impl Observer,
    ) -> Onward {
        let mut onward = Onward { mirrored: false, split: false };
        let mut rest = lanes;
        while let Some((met, run, others)) = split_run(rest) {
            rest = others;
            let object = self.scene.objects.get(usize::from(met));
            let found = object.and_then(|object| {
                Some((&object.shape, self.scene.materials.get(usize::from(object.material))?))
            });
            let Some((shape, material)) = found else {
                self.see_sky(level, run, light, observer);
                continue;
            };
            if level < self.depth {
                onward.split |= material.glass.is_some();
                onward.mirrored |= material.mirror > S::ZERO && material.glass.is_none();
            }
            let eye = if level == 0 { self.eye } else { None };
            arrive(shape, eye, run);
            if material.is_detailed() {
                refine(shape, material, run);
            }
            // A bumpy normal may send a ray into its own shape.
            let convex = shape.is_convex() && material.bump.is_none();
            self.visit(convex, material, level, run, light, observer);
        }
        onward
    }

    fn see_sky<O: Observer>(&self, level: u8, lanes: &mut [Lane<S>], light: &mut [Rgb<S>], observer: &mut O) {
        for lane in lanes {
            let tile = if O::SEES_TILES { self.scene.sky.tile(lane.ray.direction) } else { 0 };
            observer.met(lane.number, Lane::<S>::NOTHING, tile);
            let sent = self.scene.sky.color(lane.ray.direction);
            let (direction, weight) = (lane.ray.direction, self.weight(level, lane));
            observer.step(lane.number, move || Step::Leaves { level, direction, weight });
            self.add(level, lane, sent, light, observer);
            lane.weight = Rgb::BLACK;
        }
    }

    /// Lights places of one object, convex or not, and reflects the rays that have reached a mirror.
    ///
    /// Called, not inlined: a shape that works out its surface does not have all this on the stack below it.
    #[inline(never)]
    fn visit<O: Observer>(
        &mut self,
        convex: bool,
        material: &Material<S>,
        level: u8,
        lanes: &mut [Lane<S>],
        light: &mut [Rgb<S>],
        observer: &mut O,
    ) {
        let splits = material.glass.is_some() && level < self.depth;
        let reflects = !splits && material.mirror > S::ZERO && level < self.depth;
        let ambient = self.scene.ambient * material.ambient;
        for lane in lanes {
            let direction = lane.ray.direction;
            let mut surface = lane.surface();
            let slope = surface.normal.dot(direction);
            let outside = slope <= S::ZERO;
            if !outside {
                surface.normal = -surface.normal;
            }
            let from = Departure { index: lane.met, free: outside && convex };
            let tile = if O::SEES_TILES { tile(material, &surface) } else { 0 };
            observer.met(lane.number, lane.met, tile);
            let (distance, number) = (lane.interval.far, lane.number);
            let facing = slope.abs();
            let (object, weight) = (lane.met, self.weight(level, lane));
            observer.step(number, move || Step::Meets {
                level,
                object,
                distance,
                surface,
                direction,
                weight,
            });
            let site =
                Site { surface, material, ambient, direction, facing, distance, from, level, lane: number };
            let sent = self.shader.direct(&site, observer);
            self.add(level, lane, sent, light, observer);
            if !(reflects || splits) {
                lane.weight = Rgb::BLACK;
                continue;
            }
            if level == 0 {
                lane.weight = self.exposure;
            }
            if reflects {
                lane.ray.direction = unit_reflection(direction, surface.normal);
                (lane.interval, lane.met, lane.from) = (Interval::AHEAD, Lane::<S>::NOTHING, from);
                lane.weight = lane.weight * material.mirror;
            }
        }
    }

    /// Adds what a lane's surface or sky sends, as far as it reaches the eye; of what is seen
    /// directly all does, but for the exposure.
    fn add(
        &self,
        level: u8,
        lane: &Lane<S>,
        sent: Rgb<S>,
        light: &mut [Rgb<S>],
        observer: &mut impl Observer,
    ) {
        let Some(light) = light.get_mut(usize::from(lane.number)) else { return };
        if level > 0 {
            *light += lane.weight * sent;
        } else {
            *light = if self.exposed { self.exposure * sent } else { sent };
        }
        let gathered = *light;
        observer.step(lane.number, move || Step::Sends { light: sent, gathered });
    }

    /// Answers what reaches the eye of the light that a lane brings: of what is seen directly all, exposed.
    fn weight(&self, level: u8, lane: &Lane<S>) -> Rgb<S> {
        if level > 0 { lane.weight } else { self.exposure }
    }
}

/// Tells whether any ray of a packet goes on.
pub(super) struct Onward {
    /// Some mirror has sent one on.
    mirrored: bool,
    /// Some have reached glass.
    split: bool,
}

/// Answers a number of the part and the tile that a place belongs to.
pub(super) fn tile<S: Scalar>(material: &Material<S>, surface: &Surface<S>) -> u32 {
    material.tile(surface) ^ u32::from(surface.part).rotate_right(3)
}

/// Answers the mirror direction, of unit length again so that rounding does not grow from bounce
/// to bounce.
pub(super) fn unit_reflection<S: Scalar>(direction: Vec3<S>, normal: Vec3<S>) -> Vec3<S> {
    direction.reflect(normal).straighten()
}

/// Answers what the first lanes have met, those that have met the same, and all after them; `None` of no lanes.
///
/// The standard library's `chunk_by_mut` carries a panic.
#[inline]
#[expect(clippy::type_complexity, reason = "the parts of a slice")]
fn split_run<S: Scalar>(lanes: &mut [Lane<S>]) -> Option<(u16, &mut [Lane<S>], &mut [Lane<S>])> {
    let met = lanes.first()?.met;
    let end = lanes.iter().position(|lane| lane.met != met).unwrap_or(lanes.len());
    let (run, others) = lanes.split_at_mut_checked(end)?;
    Some((met, run, others))
}

/// Moves the lanes whose weight is more than `faint` to the front and answers how many they are.
fn gather<S: Scalar>(lanes: &mut [Lane<S>], faint: S) -> usize {
    let mut going = 0;
    for at in 0..lanes.len() {
        let Some(lane) = lanes.get(at).filter(|lane| lane.weight.max() > faint).copied() else { continue };
        if let Some(place) = lanes.get_mut(going).filter(|_| at != going) {
            *place = lane;
        }
        // At most `at` + 1.
        going = going.wrapping_add(1);
    }
    going
}
