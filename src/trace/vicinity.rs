//! What can stand between a light and a small region: found once, asked for many pixels.
//!
//! Neighbouring pixels mostly see neighbouring points. Around a lit point a cube is laid, and the
//! objects that reach into the beam between cube and light are noted; as long as lit points stay
//! in the cube only those are asked for shadows. What is noted never decides: it leaves out only
//! objects that no shadow ray of the cube can meet.

use super::departure::Departure;
use crate::aabb::Aabb;
use crate::hull::Hull;
use crate::light::{Light, Spot};
use crate::math::{Scalar, Vec3};
use crate::scene::Scene;
use crate::shape::Intersect;

/// Is how many objects are noted one by one: those that follow may always block.
pub(super) const NOTED: usize = 128;

/// Is how many words of bits that takes.
pub(super) const WORDS: usize = NOTED / 32;

/// Is how many cubes are remembered, one a light.
const PLACES: usize = 4;

/// Remembers a cube for each light.
///
/// It serves points seen directly. In a curved mirror neighbouring pixels see points far apart, and
/// a cube that is left at once costs more than it saves: 4 % of a picture of balls.
#[derive(Clone, Debug)]
pub struct Vicinities<S: Scalar> {
    places: [Vicinity<S>; PLACES],
}

/// Is a cube with what may stand between it and one light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vicinity<S: Scalar> {
    /// The light that this was found for.
    owner: u16,
    center: Vec3<S>,
    /// Half the side of the cube; 0 for none.
    reach: S,
    /// Whether no object of the scene is left out of those noted.
    all_noted: bool,
    /// Objects that may block, a bit each.
    pub blockers: [u32; WORDS],
    /// How many words have any bit set, those after the last one not counted.
    pub words: u8,
    /// The object that blocked last.
    pub last: u16,
}

impl<S: Scalar> Vicinity<S> {
    const NOWHERE: Self = Self {
        owner: 0,
        center: Vec3::ZERO,
        reach: S::ZERO,
        all_noted: false,
        blockers: [0; WORDS],
        words: 0,
        last: 0,
    };

    fn contains(&self, point: Vec3<S>) -> bool {
        let off = point - self.center;
        off.x.abs() < self.reach && off.y.abs() < self.reach && off.z.abs() < self.reach
    }

    /// Tells whether nothing but the object left can stand in the light.
    pub fn is_open(&self, from: Departure) -> bool {
        let left = if from.free { 1_u32.checked_shl(u32::from(from.index)).unwrap_or(0) } else { 0 };
        self.all_noted && self.words <= 1 && self.blockers[0] & !left == 0
    }

    /// Lays the cube around a point. Rare, and kept out of the pixel's path.
    #[cold]
    #[inline(never)]
    fn move_to<X: Intersect<S>>(&mut self, scene: &Scene<'_, S, X>, owner: u16, point: Vec3<S>, distance: S) {
        // 1/16 of the distance is some 20 pixels of a picture of 320 columns.
        let reach = distance * S::HALF * S::HALF * S::HALF * S::HALF;
        let Some(light) = scene.lights.get(usize::from(owner)) else { return };
        let blockers = Beam::new(point, reach, light).blockers(scene);
        let all_noted = scene.objects.len() <= NOTED;
        let words = blockers.iter().rposition(|word| *word != 0).map_or(0, |last| last as u8 + 1);
        *self = Self { owner, center: point, reach, all_noted, blockers, words, last: self.last };
    }
}

impl<S: Scalar> Vicinities<S> {
    /// Makes a memory of nothing.
    pub const fn new() -> Self {
        Self { places: [Vicinity::NOWHERE; PLACES] }
    }

    /// Forgets everything: a new scene begins.
    pub fn clear(&mut self) {
        *self = Self::new();
    }

    /// Answers the vicinity of a point for a light, named by its number.
    ///
    /// Where it is not the one remembered, a new cube is laid around the point, the larger the
    /// farther the viewer is.
    #[inline]
    pub(super) fn of<X: Intersect<S>>(
        &mut self,
        scene: &Scene<'_, S, X>,
        owner: u16,
        point: Vec3<S>,
        distance: S,
    ) -> &mut Vicinity<S> {
        let vicinity = &mut self.places[usize::from(owner) % PLACES];
        if vicinity.owner != owner || !vicinity.contains(point) {
            vicinity.move_to(scene, owner, point, distance);
        }
        vicinity
    }
}

impl<S: Scalar> Default for Vicinities<S> {
    fn default() -> Self {
        Self::new()
    }
}

/// Is all shadow rays from a cube to a light, and a little more: the ball around the cube, swept
/// to the light.
struct Beam<S: Scalar> {
    from: Vec3<S>,
    toward: Vec3<S>,
    length: S,
    /// Radius of the ball, rounding included.
    radius: S,
}

impl<S: Scalar> Beam<S> {
    fn new(center: Vec3<S>, reach: S, light: &Light<S>) -> Self {
        // The ball around a cube reaches sqrt(3) = 1.73 times as far as its sides.
        let ball = reach + reach;
        let (toward, length) = match *light {
            Light::Point { position, .. } | Light::Spot(Spot { position, .. }) => {
                (position - center).normalize()
            }
            Light::Directional { toward, .. } => toward.normalize().map(|(unit, _)| (unit, S::FAR)),
        }
        .unwrap_or((Vec3::ZERO, S::ZERO));
        let [x, y, z] = center.to_array().map(S::abs);
        Self { from: center, toward, length, radius: ball + (x + y + z + S::ONE) * S::SLACK }
    }

    /// Answers the objects that reach into the beam, a bit each.
    fn blockers<X: Intersect<S>>(&self, scene: &Scene<'_, S, X>) -> [u32; WORDS] {
        let mut words = [0; WORDS];
        for (word, objects) in words.iter_mut().zip(scene.objects.chunks(32)) {
            let bits = (0..u32::BITS).zip(objects);
            *word = bits.fold(0, |word, (bit, object)| {
                word | u32::from(self.meets(&object.shape.hull())).wrapping_shl(bit)
            });
        }
        words
    }

    /// Called, not inlined: a shape that works out its hull does not have all this on the stack below it.
    #[inline(never)]
    fn meets(&self, hull: &Hull<S>) -> bool {
        match *hull {
            Hull::Ball { center, radius } => self.meets_ball(center, radius),
            Hull::Plane { point, normal } => self.meets_plane(point, normal),
            Hull::Everything => true,
            _ => hull.bounds().is_none_or(|bounds| self.meets_box(&bounds)),
        }
    }

    fn meets_ball(&self, center: Vec3<S>, radius: S) -> bool {
        let from_start = center - self.from;
        let ahead = from_start.dot(self.toward).max(S::ZERO).min(self.length);
        let off = from_start - self.toward * ahead;
        let slack = ahead * S::SLACK;
        let reach = radius + self.radius + slack;
        off.dot_wide(off) <= reach.mul_wide(reach)
    }

    fn meets_plane(&self, point: Vec3<S>, normal: Vec3<S>) -> bool {
        let Some((normal, _)) = normal.normalize() else { return true };
        let height = (point - self.from).dot(normal);
        let slack = self.radius + height.abs() * S::SLACK;
        // Rays that go off from the plane's side, or end before it.
        let rise = self.toward.dot(normal);
        let end = height - rise * self.length;
        height.abs() <= slack || (end < slack) != (height < S::ZERO) || end.abs() <= slack
    }

    fn meets_box(&self, bounds: &Aabb<S>) -> bool {
        let center = (bounds.center - self.from).to_array();
        let half = bounds.half.to_array();
        let mut slabs = center.into_iter().zip(half).zip(self.toward.to_array());
        slabs.all(|((center, half), toward)| {
            let end = toward * self.length;
            let reach = half + self.radius + (center.abs() + end.abs()) * S::SLACK;
            center + reach >= end.min(S::ZERO) && center - reach <= end.max(S::ZERO)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Fixed, Rgb};

    #[test]
    fn a_cube_not_laid_yet_holds_no_point_not_even_the_origin() {
        assert!(!Vicinity::<f32>::NOWHERE.contains(Vec3::ZERO));
        assert!(!Vicinity::<Fixed>::NOWHERE.contains(Vec3::ZERO));
    }

    fn check<S: Scalar>(make: fn(f64) -> S) {
        let at = |x: f64, y: f64, z: f64| Vec3::new(make(x), make(y), make(z));
        // From a cube of side 1 in the origin, its ball taken to be of radius 1, to a lamp 10 above.
        let beam = Beam::new(Vec3::ZERO, S::HALF, &Light::point(at(0.0, 10.0, 0.0), Rgb::WHITE));
        let ball: fn(Vec3<S>) -> Hull<S> = |center| Hull::Ball { center, radius: S::ONE };
        let cuboid = |center| Hull::Box(Aabb { center, half: Vec3::new(S::ONE, S::ONE, S::ONE) });
        let ground = |height| Hull::Plane { point: at(0.0, height, 0.0), normal: at(0.0, 1.0, 0.0) };
        for hull in [ball, cuboid] {
            for inside in [at(1.9, 5.0, 0.0), at(0.0, 5.0, -1.9), at(0.0, 11.9, 0.0), at(0.0, -1.9, 0.0)] {
                assert!(beam.meets(&hull(inside)), "{inside:?}");
            }
            for beside in [at(2.1, 5.0, 0.0), at(0.0, 5.0, -2.1), at(0.0, 12.1, 0.0), at(0.0, -2.1, 0.0)] {
                assert!(!beam.meets(&hull(beside)), "{beside:?}");
            }
        }
        // Between a ball and the edge of its box.
        assert!(!beam.meets(&ball(at(1.6, 5.0, 1.6))));
        assert!([-0.9, 5.0, 10.9].iter().all(|height| beam.meets(&ground(*height))));
        assert!([-1.1, 11.1].iter().all(|height| !beam.meets(&ground(*height))));
    }

    #[test]
    fn what_stands_beside_the_beam_of_a_lamp_is_left_out() {
        check(|x| x as f32);
        check(Fixed::new);
        check(|x| x);
    }
}
