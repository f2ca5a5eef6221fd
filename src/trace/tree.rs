use super::departure::Departure;
use super::lane::Lane;
use super::observer::{Observer, RayKind};
use super::pending::{Pending, SPACE};
use super::step::Step;
use super::tracer::{Tracer, unit_reflection};
use crate::color::Rgb;
use crate::glass::{Glass, refract};
use crate::math::Scalar;
use crate::ray::{Interval, Ray};
use crate::scene::Scene;
use crate::shape::Intersect;
use core::slice;

impl<S: Scalar, X: Intersect<S>> Tracer<'_, '_, S, X> {
    /// Follows a ray on from glass, where it splits into a mirrored and a refracted ray, and all that
    /// these split into; the lane stands on the glass, lit.
    ///
    /// One of the two is followed on, the other waits. Rays are taken up again deepest first, so that
    /// when a ray of some level is followed at most one ray of each level up to its own waits: as many
    /// places as there are levels hold every tree, and a tracer goes no deeper than it has places.
    #[inline(never)]
    pub(super) fn follow_tree(
        &mut self,
        start_level: u8,
        start: &Lane<S>,
        light: &mut [Rgb<S>],
        observer: &mut impl Observer,
    ) {
        let (mut lane, mut level, mut within) = (*start, start_level, None);
        // The tree of a ray may be cut at 2^depth places.
        let faint = (0..self.depth).fold(self.faint, |faint, _| faint * S::HALF);
        let mut waiting = 0;
        loop {
            if lane.splits() {
                let refracted = self.split(&mut lane, &mut within);
                let (reflected, through) = (lane.weight, refracted.weight);
                observer.step(lane.number, move || Step::Splits { reflected, refracted: through });
                if let Some(place) = self.pending.get_mut(waiting).filter(|_| refracted.weight.max() > faint)
                {
                    *place = Pending { level: level.saturating_add(1), ..refracted };
                    waiting += 1;
                }
            }
            if lane.weight.max() > faint {
                observer.ray(RayKind::Reflection);
                level = level.saturating_add(1);
            } else {
                let next = waiting.checked_sub(1).and_then(|last| self.pending.get(last));
                let Some(next) = next else { return };
                observer.ray(RayKind::Refraction);
                lane.go_on(next.ray, next.from, next.weight);
                (level, within) = (next.level, Some(next.within));
                waiting -= 1;
            }
            let alone = slice::from_mut(&mut lane);
            self.seek_mirrored(alone);
            if let Some(glass) = within.and_then(|within| glass_of(self.scene, within)) {
                lane.weight = lane.weight * glass.left_after(lane.interval.far);
            }
            self.light_up(level, slice::from_mut(&mut lane), light, observer);
        }
    }

    /// Splits the ray of a lane that stands on glass: the lane goes on mirrored, the answer goes
    /// through; what does not exist weighs nothing.
    ///
    /// `within` is the material that the ray has come through, `None` when that is not known yet; then
    /// what it takes of the light comes off here.
    fn split(&self, lane: &mut Lane<S>, within: &mut Option<u16>) -> Pending<S> {
        let Lane { ray: Ray { origin, direction }, met, weight, .. } = *lane;
        lane.weight = Rgb::BLACK;
        let Some(object) = self.scene.objects.get(usize::from(met)) else { return Pending::NONE };
        let material = self.scene.materials.get(usize::from(object.material));
        let Some((material, glass)) = material.and_then(|stuff| Some((stuff, stuff.glass.as_ref()?))) else {
            return Pending::NONE;
        };
        let inside = lane.normal.dot(direction) > S::ZERO;
        let normal = if inside { -lane.normal } else { lane.normal };
        let around = around(self.scene, &lane.ray, met);
        let weight = match within {
            Some(_) => weight,
            None => {
                let passed = if inside { object.material } else { around };
                let left = glass_of(self.scene, passed).map(|glass| glass.left_after(lane.interval.far));
                *within = Some(passed);
                left.map_or(weight, |left| weight * left)
            }
        };
        let outer = glass_of(self.scene, around).map_or(S::ONE, |glass| glass.index);
        let indices = if inside { [glass.index, outer] } else { [outer, glass.index] };
        let bent = refract(direction, normal, indices[0].ratio(indices[1]));
        let turned_back = bent.map_or(S::ONE, |(_, refracted)| {
            glass.fresnel.reflectance(indices, [-direction.dot(normal), refracted])
        });
        // A bumpy normal may send a ray into its own shape.
        let convex = object.shape.is_convex() && material.bump.is_none();
        let from = |free| Departure { index: met, free: free && convex };
        let mirrored = Ray::new(origin, unit_reflection(direction, normal));
        lane.go_on(mirrored, from(!inside), weight * (material.mirror + glass.transmission * turned_back));
        let Some((direction, _)) = bent else { return Pending::NONE };
        Pending {
            ray: Ray::new(origin, direction),
            weight: weight * (glass.transmission * (S::ONE - turned_back)),
            from: from(inside),
            within: if inside { around } else { object.material },
            level: 0,
        }
    }
}

/// Answers the glass of a material, if it is one.
fn glass_of<'a, S: Scalar, X>(scene: &Scene<'a, S, X>, material: u16) -> Option<&'a Glass<S>> {
    scene.materials.get(usize::from(material))?.glass.as_ref()
}

/// Answers the material of the glass in which a point of an object's surface stands, that object left
/// out, or [`SPACE`].
///
/// A ray from inside a closed shape first meets it from inside; of shapes that do not cut each other the
/// nearest such is the innermost.
fn around<S: Scalar, X: Intersect<S>>(scene: &Scene<'_, S, X>, ray: &Ray<S>, but: u16) -> u16 {
    let (mut interval, mut innermost) = (Interval::AHEAD, SPACE);
    for (index, object) in (0..u16::MAX).zip(scene.objects) {
        if index == but || glass_of(scene, object.material).is_none() {
            continue;
        }
        let Some(crossing) = object.shape.intersect(ray, &interval) else { continue };
        if object.shape.surface(ray, &crossing).normal.dot(ray.direction) > S::ZERO {
            (interval.far, innermost) = (crossing.t, object.material);
        }
    }
    innermost
}
