use super::lane::Lane;
use crate::hit::Surface;
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
        lanes.iter_mut().for_each(|lane| {
            lane.normal = bent(shape, bump, &lane.surface(), lane.ray.direction);
        });
    }
}

/// Works out the same for one surface, seen along a direction.
#[inline(never)]
pub(super) fn refine_one<S: Scalar, X: Intersect<S>>(
    shape: &Shape<S, X>,
    material: &Material<S>,
    surface: &mut Surface<S>,
    direction: Vec3<S>,
) {
    [surface.u, surface.v] = shape.texture_coordinates(surface);
    if let Some(bump) = material.bump.as_ref().filter(|_| cfg!(feature = "images")) {
        surface.normal = bent(shape, bump, surface, direction);
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
fn bent<S: Scalar>(
    shape: &impl Intersect<S>,
    bump: &Bump<S>,
    surface: &Surface<S>,
    direction: Vec3<S>,
) -> Vec3<S> {
    let tangents = shape.tangents(surface);
    let normal = bend(surface.normal, &tangents, bump.slopes(surface.u, surface.v, &tangents));
    let turned_away = (normal.dot(direction) > S::ZERO) != (surface.normal.dot(direction) > S::ZERO);
    if turned_away { normal.reflect(direction) } else { normal }
}
