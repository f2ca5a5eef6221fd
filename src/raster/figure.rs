//! The shapes that the z-buffer knows, in one list.

use super::depths::{Fragment, Painter};
use super::slice::Slice;
use super::{ball, clearance, cuboid, level, triangle};
use crate::fault::Fault;
use crate::math::{Scalar, Vec3};
use crate::scene::{Scene, SceneError};
use crate::shape::{Cuboid, Plane, Shape, Sphere, Triangle};
use crate::trace::Observer;

/// Is a shape that can be put into a row of depths.
enum Figure<'a, S> {
    Ball(&'a Sphere<S>),
    Level(&'a Plane<S>),
    Triangle(&'a Triangle<S>),
    Box(&'a Cuboid<S>),
}

impl<'a, S: Scalar> Figure<'a, S> {
    fn of<X>(shape: &'a Shape<S, X>) -> Option<Self> {
        match shape {
            Shape::Sphere(ball) => Some(Self::Ball(ball)),
            Shape::Plane(plane) => Some(Self::Level(plane)),
            Shape::Triangle(triangle) => Some(Self::Triangle(triangle)),
            Shape::Cuboid(cuboid) => Some(Self::Box(cuboid)),
            _ => None,
        }
    }

    fn clearance(&self, eye: Vec3<S>) -> S {
        match self {
            Self::Ball(ball) => clearance::of_ball(ball, eye),
            Self::Level(plane) => clearance::of_plane(plane, eye),
            Self::Triangle(triangle) => clearance::of_triangle(triangle, eye),
            Self::Box(cuboid) => clearance::of_box(cuboid, eye),
        }
    }

    fn paint<O: Observer>(&self, slice: &Slice<S>, painter: &mut Painter<'_, S, O>) {
        match self {
            Self::Ball(ball) => ball::paint(ball, slice, painter),
            Self::Level(plane) => level::paint(plane, slice, painter),
            Self::Triangle(triangle) => triangle::paint(triangle, slice, painter),
            Self::Box(cuboid) => cuboid::paint(cuboid, slice, painter),
        }
    }
}

/// Answers a distance from an eye within which nothing of a scene stands.
///
/// # Errors
/// A volume, or the first object of a shape that is not known here.
pub(super) fn clearance<S: Scalar, X>(scene: &Scene<'_, S, X>, eye: Vec3<S>) -> Result<S, SceneError> {
    if scene.volume.is_some() {
        return Err(SceneError::Volume(Fault::NotRasterized));
    }
    scene.objects.iter().enumerate().try_fold(S::FAR, |clear, (index, object)| {
        let figure = Figure::of(&object.shape);
        let figure = figure.ok_or(SceneError::Object(index, Fault::NotRasterized))?;
        Ok(clear.min(figure.clearance(eye)))
    })
}

/// Puts all objects of a scene into a row of depths that holds nothing yet.
///
/// Called, not inlined: it is off the stack again before the row is lit.
#[inline(never)]
pub(super) fn paint<S: Scalar, X, O: Observer>(
    scene: &Scene<'_, S, X>,
    slice: &Slice<S>,
    row: &mut [Fragment<S>],
    observer: &mut O,
) {
    for (object, found) in (0..Fragment::<S>::NOTHING).zip(scene.objects) {
        if let Some(figure) = Figure::of(&found.shape) {
            figure.paint(slice, &mut Painter { row, object, observer });
        }
    }
}
