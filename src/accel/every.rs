use super::{Hierarchy, Visit};
use crate::fault::Fault;
use crate::math::Scalar;
use crate::ray::{Interval, Ray};

/// Names every thing to every ray, in their order: the way to do without a hierarchy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Every(pub u16);

impl<S: Scalar> Hierarchy<S> for Every {
    fn walk(&self, _: &Ray<S>, interval: &Interval<S>, visit: Visit<'_, S>) {
        for number in 0..self.0 {
            if visit(number) <= interval.near {
                return;
            }
        }
    }

    fn count(&self) -> u16 {
        self.0
    }

    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}
