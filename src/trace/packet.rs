use super::departure::Departure;
use super::lane::{LANES, Lane};
use super::observer::{Observer, RayKind};
use super::step::Step;
use super::visibility::Candidates;
use crate::color::Rgb;
use crate::math::Scalar;
use crate::ray::{Interval, Ray};

/// Is a handful of rays that are traced together, and the light that comes along each.
#[derive(Clone, Debug)]
pub struct Packet<S: Scalar> {
    pub(super) lanes: [Lane<S>; LANES],
    pub(super) light: [Rgb<S>; LANES],
}

impl<S: Scalar> Packet<S> {
    /// Makes a packet of no rays.
    pub const fn new() -> Self {
        Self { lanes: [Lane::IDLE; LANES], light: [Rgb::BLACK; LANES] }
    }

    /// Takes up primary rays as [`Packet::load`] does.
    ///
    /// Called, not inlined: what a ray is made of, 200 bytes on an M0+, is off the stack again before it is
    /// traced.
    #[inline(never)]
    pub(crate) fn take_up(
        &mut self,
        rays: impl Iterator<Item = (Ray<S>, Interval<S>)>,
        candidates: &Candidates<'_>,
        observer: &mut impl Observer,
    ) -> usize {
        self.load(rays, candidates, observer)
    }

    /// Takes up primary rays, as many as there is room for, and answers their number; an observer is told what they may
    /// meet.
    ///
    /// Inlined into whoever steps the rays, so that they are stepped in registers: through a reference it
    /// takes an M0+ 13 to 26 instructions more a ray.
    #[inline(always)]
    pub(crate) fn load(
        &mut self,
        rays: impl Iterator<Item = (Ray<S>, Interval<S>)>,
        candidates: &Candidates<'_>,
        observer: &mut impl Observer,
    ) -> usize {
        let mut count = 0;
        for (lane, (ray, interval)) in self.lanes.iter_mut().zip(rays) {
            (lane.ray, lane.interval) = (ray, interval);
            (lane.met, lane.from, lane.number) = (Lane::<S>::NOTHING, Departure::NOWHERE, count);
            // At most the number of lanes.
            count = count.wrapping_add(1);
            observer.ray(RayKind::Primary);
            let candidates = candidates.clone();
            observer.step(lane.number, move || Step::SetsOut { ray, interval, candidates });
        }
        usize::from(count)
    }
}

impl<S: Scalar> Default for Packet<S> {
    fn default() -> Self {
        Self::new()
    }
}
