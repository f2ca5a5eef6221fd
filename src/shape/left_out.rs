use super::Intersect;
use crate::fault::Fault;
use crate::hit::{Crossing, Surface};
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};

/// Stands for a shape whose code this program was built without, named by the feature: a scene that has one is
/// refused.
pub(crate) struct LeftOut(pub &'static str);

impl<S: Scalar> Intersect<S> for LeftOut {
    fn intersect(&self, _: &Ray<S>, _: &Interval<S>) -> Option<Crossing<S>> {
        None
    }

    fn surface(&self, ray: &Ray<S>, _: &Crossing<S>) -> Surface<S> {
        Surface { point: ray.origin, normal: Vec3::ZERO, u: S::ZERO, v: S::ZERO, part: 0 }
    }

    fn check(&self) -> Result<(), Fault> {
        Err(Fault::LeftOut(self.0))
    }
}
