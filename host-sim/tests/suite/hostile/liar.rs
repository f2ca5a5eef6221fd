//! A user's shape that answers nonsense.

use super::values::Values;
use host_sim::rounded::Rounded;
use scanray::hit::{Crossing, Surface};
use scanray::ray::{Interval, Ray};
use scanray::{Intersect, Scalar, Vec3};

/// Is met wherever and however it says, though no such surface can be; but no farther than it is asked.
#[derive(Clone, Copy, Debug)]
pub struct Liar<S> {
    t: S,
    part: u16,
    normal: Vec3<S>,
    place: [S; 2],
}

impl<S: Rounded> Liar<S> {
    pub fn new(values: &mut Values<S>) -> Self {
        let part = values.dice.pick(&[0, 1, u16::MAX]);
        Self { t: values.length(), part, normal: values.direction(), place: values.place() }
    }
}

impl<S: Scalar> Intersect<S> for Liar<S> {
    fn intersect(&self, _: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        interval.contains(self.t).then_some(Crossing { part: self.part, ..Crossing::at(self.t) })
    }

    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        let [u, v] = self.place;
        Surface { point: ray.at(crossing.t), normal: self.normal, u, v, part: self.part }
    }
}
