use crate::growth::Tally;
use scanray::hit::{Crossing, Surface, Tangent};
use scanray::hull::Hull;
use scanray::ray::{Interval, Ray};
use scanray::{Fault, Intersect, Shape};
use std::cell::Cell;

thread_local! {
    static ASKED: Cell<u64> = const { Cell::new(0) };
}

/// Is a shape that counts how often a ray asks it, on each thread by itself; all else it leaves to the shape.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counted(pub Shape<Tally>);

impl Counted {
    /// Answers how often shapes have been asked on this thread so far.
    pub fn asked() -> u64 {
        ASKED.get()
    }

    fn ask(&self) -> &Shape<Tally> {
        ASKED.set(ASKED.get() + 1);
        &self.0
    }
}

impl Intersect<Tally> for Counted {
    fn intersect(&self, ray: &Ray<Tally>, interval: &Interval<Tally>) -> Option<Crossing<Tally>> {
        self.ask().intersect(ray, interval)
    }

    fn intersect_leaving(&self, ray: &Ray<Tally>, interval: &Interval<Tally>) -> Option<Crossing<Tally>> {
        self.ask().intersect_leaving(ray, interval)
    }

    fn occludes(&self, ray: &Ray<Tally>, interval: &Interval<Tally>) -> bool {
        self.ask().occludes(ray, interval)
    }

    fn occludes_leaving(&self, ray: &Ray<Tally>, interval: &Interval<Tally>) -> bool {
        self.ask().occludes_leaving(ray, interval)
    }

    fn surface(&self, ray: &Ray<Tally>, crossing: &Crossing<Tally>) -> Surface<Tally> {
        self.0.surface(ray, crossing)
    }

    fn texture_coordinates(&self, surface: &Surface<Tally>) -> [Tally; 2] {
        self.0.texture_coordinates(surface)
    }

    fn tangents(&self, surface: &Surface<Tally>) -> [Tangent<Tally>; 2] {
        self.0.tangents(surface)
    }

    fn is_convex(&self) -> bool {
        Intersect::<Tally>::is_convex(&self.0)
    }

    fn hull(&self) -> Hull<Tally> {
        self.0.hull()
    }

    fn check(&self) -> Result<(), Fault> {
        Intersect::<Tally>::check(&self.0)
    }
}
