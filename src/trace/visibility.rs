use crate::hit::Crossing;
use crate::math::Scalar;
use crate::ray::{Interval, Ray};
use crate::scene::{Object, Scene};
use crate::shape::Intersect;

/// Is the nearest object a ray meets.
#[derive(Clone, Copy, Debug)]
pub struct Found<'a, S: Scalar, X> {
    /// Place of the object in the scene's list.
    pub index: u16,
    /// The object.
    pub object: &'a Object<S, X>,
    /// Where it is met.
    pub crossing: Crossing<S>,
}

fn meet<S: Scalar, X: Intersect<S>>(
    object: &Object<S, X>,
    leaves: bool,
    ray: &Ray<S>,
    interval: &Interval<S>,
) -> Option<Crossing<S>> {
    if leaves { object.shape.intersect_leaving(ray, interval) } else { object.shape.intersect(ray, interval) }
}

/// Finds the nearest of the objects named by `candidates`.
///
/// `leaving` names the object on whose surface the ray starts. Of two objects met at the same
/// distance the one listed first wins.
pub fn nearest<'a, S: Scalar, X: Intersect<S>>(
    scene: &Scene<'a, S, X>,
    candidates: impl Iterator<Item = u16>,
    ray: &Ray<S>,
    mut interval: Interval<S>,
    leaving: Option<u16>,
) -> Option<Found<'a, S, X>> {
    let mut best = None;
    for index in candidates {
        let Some(object) = scene.objects.get(usize::from(index)) else { continue };
        if let Some(crossing) = meet(object, leaving == Some(index), ray, &interval) {
            interval.far = crossing.t;
            best = Some(Found { index, object, crossing });
        }
    }
    best
}

/// Tells whether anything stands inside the interval (row L7).
pub fn occluded<S: Scalar, X: Intersect<S>>(
    scene: &Scene<'_, S, X>,
    ray: &Ray<S>,
    interval: &Interval<S>,
    leaving: Option<u16>,
) -> bool {
    let leaving = leaving.map(usize::from);
    let mut objects = scene.objects.iter().enumerate();
    objects.any(|(index, object)| meet(object, leaving == Some(index), ray, interval).is_some())
}
