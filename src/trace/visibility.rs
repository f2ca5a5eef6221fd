//! What rays meet: the nearest object, and whether anything stands before a light.

use super::lane::Lane;
use crate::accel::Hierarchy;
use crate::hit::Crossing;
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};
use crate::scene::Scene;
use crate::shape::{Intersect, Shape, dispatch};
use core::ops::Range;

/// Names the objects a ray may meet, by their places in the scene's list, in rising order; those of the scene's
/// hierarchy are not among them.
#[derive(Clone, Debug)]
pub struct Candidates<'c> {
    /// Objects named one by one.
    pub named: &'c [u16],
    /// All objects from one place on.
    pub rest: Range<u16>,
}

impl Candidates<'_> {
    /// Tells whether no object is named.
    pub fn is_empty(&self) -> bool {
        self.named.is_empty() && self.rest.is_empty()
    }
}

impl Candidates<'static> {
    /// Names all objects of a scene that are not in its hierarchy.
    pub fn all<S: Scalar, X>(scene: &Scene<'_, S, X>) -> Self {
        Self { named: &[], rest: scene.loose() }
    }
}

/// Finds the nearest object of each ray; of two at the same distance the one listed first.
///
/// `eye` is where all rays start, if they start at one point off all surfaces.
pub(super) fn nearest<S: Scalar, X: Intersect<S>>(
    scene: &Scene<'_, S, X>,
    candidates: Candidates<'_>,
    eye: Option<Vec3<S>>,
    lanes: &mut [Lane<S>],
) {
    let Candidates { named, rest } = candidates;
    for index in named.iter().copied().chain(rest) {
        let Some(object) = scene.objects.get(usize::from(index)) else { continue };
        match (eye, &object.shape) {
            (Some(eye), Shape::Sphere(sphere)) => look_out(sphere, index, eye, lanes),
            (_, shape) => dispatch!(shape, shape => look(shape, index, lanes)),
        }
    }
    if let Some(tree) = scene.tree() {
        lanes.iter_mut().for_each(|lane| look_among(scene, tree, lane));
    }
}

/// Finds the nearest object of a hierarchy, if it is nearer than what the ray has met.
#[inline(never)]
fn look_among<S: Scalar, X: Intersect<S>>(
    scene: &Scene<'_, S, X>,
    tree: &dyn Hierarchy<S>,
    lane: &mut Lane<S>,
) {
    let (ray, interval) = (lane.ray, lane.interval);
    tree.walk(&ray, &interval, &mut |index| {
        let far = lane.interval.far;
        // Of two at the same distance the one listed first counts, in whichever order they are named.
        let first = lane.met != Lane::<S>::NOTHING && index < lane.met;
        let look = Interval::new(interval.near, if first { far.next_up() } else { far });
        let crossing =
            scene.objects.get(usize::from(index)).and_then(|object| ask(&object.shape, index, lane, &look));
        if let Some(crossing) = crossing {
            lane.meet(index, crossing);
        }
        lane.interval.far
    });
}

/// Asks a shape about a ray that may start on it.
fn ask<S: Scalar>(
    shape: &impl Intersect<S>,
    index: u16,
    lane: &Lane<S>,
    interval: &Interval<S>,
) -> Option<Crossing<S>> {
    if lane.from.index != index {
        shape.intersect(&lane.ray, interval)
    } else if lane.from.free {
        None
    } else {
        shape.intersect_leaving(&lane.ray, interval)
    }
}

/// Asks a shape about rays from one point off all surfaces: what the shape works out of that point alone is
/// worked out once.
fn look_out<S: Scalar>(shape: &impl Intersect<S>, index: u16, eye: Vec3<S>, lanes: &mut [Lane<S>]) {
    for lane in lanes {
        if let Some(crossing) = shape.intersect(&Ray::new(eye, lane.ray.direction), &lane.interval) {
            lane.meet(index, crossing);
        }
    }
}

/// Asks a shape about rays that each have their own start.
fn look<S: Scalar>(shape: &impl Intersect<S>, index: u16, lanes: &mut [Lane<S>]) {
    for lane in lanes {
        let interval = lane.interval;
        if let Some(crossing) = ask(shape, index, lane, &interval) {
            lane.meet(index, crossing);
        }
    }
}

/// Puts rays that have met one shape onto its surface.
///
/// Called, not inlined: what shapes work out here is off the stack again before the surface is lit.
#[inline(never)]
pub(super) fn arrive<S: Scalar, X: Intersect<S>>(
    shape: &Shape<S, X>,
    eye: Option<Vec3<S>>,
    lanes: &mut [Lane<S>],
) {
    dispatch!(shape, shape => arrive_on(shape, eye, lanes));
}

fn arrive_on<S: Scalar>(shape: &impl Intersect<S>, eye: Option<Vec3<S>>, lanes: &mut [Lane<S>]) {
    for lane in lanes {
        let ray = Ray::new(eye.unwrap_or(lane.ray.origin), lane.ray.direction);
        lane.arrive(shape.surface(&ray, &lane.crossing()));
    }
}
