//! From a row of depths to light: where each pixel's hit is, its depth and its column say.

use super::depths::Fragment;
use super::slice::Slice;
use super::triangle::Coordinates;
use crate::camera::{Frame, RowRay};
use crate::color::Rgb;
use crate::hit::Crossing;
use crate::math::Scalar;
use crate::scene::Scene;
use crate::shape::{Intersect, Shape};
use crate::trace::{Observer, direct_light};

/// Turns the fragments of a row into light.
struct Shading<'r, S: Scalar, X, O> {
    scene: &'r Scene<'r, S, X>,
    slice: &'r Slice<S>,
    /// The triangle of the pixel before: what it carries along the row is found once.
    triangle: (u16, Option<Coordinates<S>>),
    observer: &'r mut O,
}

/// Answers the light of a row's pixels, from left to right.
pub(super) fn light<'r, S: Scalar, X: Intersect<S>, O: Observer>(
    scene: &'r Scene<'r, S, X>,
    frame: &'r Frame<S>,
    (y, slice): (u32, &'r Slice<S>),
    row: &'r [Fragment<S>],
    observer: &'r mut O,
) -> impl Iterator<Item = Rgb<S>> + 'r {
    let mut shading = Shading { scene, slice, triangle: (Fragment::<S>::NOTHING, None), observer };
    row.iter().zip(frame.row(y, 0)).map(move |(fragment, primary)| {
        shading.surface(fragment, &primary).unwrap_or_else(|| shading.sky(&primary))
    })
}

impl<S: Scalar, X: Intersect<S>, O: Observer> Shading<'_, S, X, O> {
    /// Answers the light of the surface that a fragment is of; `None` where there is none.
    fn surface(&mut self, fragment: &Fragment<S>, primary: &RowRay<S>) -> Option<Rgb<S>> {
        let object = self.scene.objects.get(usize::from(fragment.object))?;
        let t = self.slice.distance(fragment.nearness, primary.length);
        let [u, v] = match &object.shape {
            Shape::Triangle(triangle) => {
                if self.triangle.0 != fragment.object {
                    self.triangle = (fragment.object, Coordinates::of(triangle, self.slice));
                }
                let coordinates = self.triangle.1.as_ref()?;
                coordinates.at(self.slice.slope(&primary.ray), fragment, self.slice)
            }
            _ => [S::ZERO; 2],
        };
        let crossing = Crossing { t, part: fragment.part, u, v };
        direct_light(self.scene, fragment.object, &primary.ray, &crossing, self.observer)
    }

    fn sky(&mut self, primary: &RowRay<S>) -> Rgb<S> {
        self.observer.met(0, Fragment::<S>::NOTHING, 0);
        self.scene.sky.color(primary.ray.direction)
    }
}
