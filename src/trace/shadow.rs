use super::departure::Departure;
use super::vicinity::{NOTED, Vicinity};
use crate::math::Scalar;
use crate::ray::{Interval, Ray};
use crate::scene::Scene;
use crate::shape::Intersect;

/// Asks whether anything blocks the way to a light (row L7).
pub(super) struct Query<S: Scalar> {
    pub ray: Ray<S>,
    pub interval: Interval<S>,
    pub from: Departure,
}

impl<S: Scalar> Query<S> {
    /// Asks all objects.
    #[inline(never)]
    pub fn is_blocked<X: Intersect<S>>(&self, scene: &Scene<'_, S, X>) -> bool {
        scene.loose().any(|index| self.is_blocked_by(scene, usize::from(index)))
            || self.is_blocked_among(scene)
    }

    /// Asks the objects of the scene's hierarchy.
    fn is_blocked_among<X: Intersect<S>>(&self, scene: &Scene<'_, S, X>) -> bool {
        let Some(tree) = scene.tree() else { return false };
        let mut blocked = false;
        tree.walk(&self.ray, &self.interval, &mut |index| {
            blocked |= self.is_blocked_by(scene, usize::from(index));
            if blocked { S::ZERO } else { self.interval.far }
        });
        blocked
    }

    /// Asks the objects of a vicinity, the last blocker first, for shadows are wider than a pixel.
    #[inline(never)]
    pub fn is_blocked_near<X: Intersect<S>>(
        &self,
        scene: &Scene<'_, S, X>,
        vicinity: &mut Vicinity<S>,
    ) -> bool {
        let last = usize::from(vicinity.last);
        let word = vicinity.blockers.get(last / 32);
        let near = word.is_some_and(|word| word >> (last % 32) & 1 == 1);
        if near && self.is_blocked_by(scene, last) {
            return true;
        }
        let blocker = self.blocker(scene, vicinity, if near { last } else { usize::MAX });
        if let Some(index) = blocker {
            vicinity.last = u16::try_from(index).unwrap_or(u16::MAX);
        }
        blocker.is_some()
    }

    /// Finds an object that blocks, among those of the vicinity and those that are never noted;
    /// one is left out.
    fn blocker<X: Intersect<S>>(
        &self,
        scene: &Scene<'_, S, X>,
        vicinity: &Vicinity<S>,
        but: usize,
    ) -> Option<usize> {
        let words = vicinity.blockers.iter().take(usize::from(vicinity.words));
        for (first, word) in (0..).step_by(32).zip(words) {
            let (mut bits, mut index) = (*word, first);
            while bits != 0 {
                if bits & 1 == 1 && index != but && self.is_blocked_by(scene, index) {
                    return Some(index);
                }
                bits >>= 1;
                index += 1;
            }
        }
        (NOTED..scene.objects.len()).find(|index| self.is_blocked_by(scene, *index))
    }

    fn is_blocked_by<X: Intersect<S>>(&self, scene: &Scene<'_, S, X>, index: usize) -> bool {
        let Some(object) = scene.objects.get(index) else { return false };
        if index != usize::from(self.from.index) {
            return object.shape.occludes(&self.ray, &self.interval);
        }
        !self.from.free && object.shape.occludes_leaving(&self.ray, &self.interval)
    }
}
