use super::vicinity::{NOTED, Vicinity};
use super::visibility::Departure;
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
        self.blocker(scene, u32::MAX).is_some()
    }

    /// Asks the objects of a vicinity, the last blocker first, for shadows are wider than a pixel.
    #[inline(never)]
    pub fn is_blocked_near<X: Intersect<S>>(
        &self,
        scene: &Scene<'_, S, X>,
        vicinity: &mut Vicinity<S>,
    ) -> bool {
        let mut blockers = vicinity.blockers;
        let last = usize::from(vicinity.last);
        if last < NOTED && blockers >> last & 1 == 1 {
            if self.is_blocked_by(scene, last) {
                return true;
            }
            blockers &= !(1 << last);
        }
        let blocker = self.blocker(scene, blockers);
        if let Some(index) = blocker {
            vicinity.last = u16::try_from(index).unwrap_or(u16::MAX);
        }
        blocker.is_some()
    }

    /// Finds an object that blocks, among those whose bit is set and those that have none.
    fn blocker<X: Intersect<S>>(&self, scene: &Scene<'_, S, X>, mut blockers: u32) -> Option<usize> {
        let noted = scene.objects.len().min(NOTED);
        let mut index = 0;
        while blockers != 0 && index < noted {
            if blockers & 1 == 1 && self.is_blocked_by(scene, index) {
                return Some(index);
            }
            blockers >>= 1;
            index += 1;
        }
        (noted..scene.objects.len()).find(|index| self.is_blocked_by(scene, *index))
    }

    fn is_blocked_by<X: Intersect<S>>(&self, scene: &Scene<'_, S, X>, index: usize) -> bool {
        let Some(object) = scene.objects.get(index) else { return false };
        if index != usize::from(self.from.index) {
            return object.shape.occludes(&self.ray, &self.interval);
        }
        !self.from.free && object.shape.intersect_leaving(&self.ray, &self.interval).is_some()
    }
}
