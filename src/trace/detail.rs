use super::lane::Lane;
use crate::material::Material;
use crate::math::{Scalar, Vec3};
use crate::shape::{Intersect, Shape, dispatch};
use crate::texture::{Bump, bend};

/// Works out for rays that have met one shape what only varied or bumpy materials ask.
#[inline(never)]
pub(super) fn refine<S: Scalar, X: Intersect<S>>(
    shape: &Shape<S, X>,
    material: &Material<S>,
    lanes: &mut [Lane<S>],
) {
    dispatch!(shape, shape => chart(shape, lanes));
    if let Some(bump) = material.bump.as_ref().filter(|_| cfg!(feature = "images")) {
        lanes.iter_mut().for_each(|lane| lane.normal = bent(shape, bump, lane));
    }
}

/// Gives each lane the texture coordinates of the place it has reached; most shapes have given them
/// already.
fn chart<S: Scalar>(shape: &impl Intersect<S>, lanes: &mut [Lane<S>]) {
    for lane in lanes {
        [lane.u, lane.v] = shape.texture_coordinates(&lane.surface());
    }
}

/// Answers the normal of a bumpy surface, on the viewer's side where the plain one is (row T2).
fn bent<S: Scalar>(shape: &impl Intersect<S>, bump: &Bump<S>, lane: &Lane<S>) -> Vec3<S> {
    let tangents = shape.tangents(&lane.surface());
    let normal = bend(lane.normal, &tangents, bump.slopes(lane.u, lane.v, &tangents));
    let direction = lane.ray.direction;
    let turned_away = (normal.dot(direction) > S::ZERO) != (lane.normal.dot(direction) > S::ZERO);
    if turned_away { normal.reflect(direction) } else { normal }
}
