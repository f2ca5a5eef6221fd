//! The scene: what there is to see, as a view of slices that may live in flash.

mod buffer;
mod check;
mod extent;

pub use buffer::{Full, SceneBuffer};
pub use check::SceneError;

use crate::color::Rgb;
use crate::environment::Sky;
use crate::light::Light;
use crate::material::Material;
use crate::math::Scalar;
use crate::shape::Shape;
use crate::volume::Volume;
use core::convert::Infallible;

/// Is a shape with its material's place in the scene's list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object<S: 'static = f32, X = Infallible> {
    /// The surface.
    pub shape: Shape<S, X>,
    /// Index into [`Scene::materials`].
    pub material: u16,
}

impl<S, X> Object<S, X> {
    /// Makes an object of a shape and the index of its material.
    pub const fn new(shape: Shape<S, X>, material: u16) -> Self {
        Self { shape, material }
    }
}

/// Is all there is to see: borrowed, so that a `static` scene costs no RAM.
///
/// The same scene from flash and from a [`SceneBuffer`] draws the same picture. The order of the
/// objects does not matter, but where two surfaces coincide: there the first one listed is seen.
#[derive(Debug, PartialEq)]
pub struct Scene<'a, S: 'static = f32, X = Infallible> {
    /// Shapes with their materials.
    pub objects: &'a [Object<S, X>],
    /// What the objects are made of.
    pub materials: &'a [Material<S>],
    /// Where light comes from.
    pub lights: &'a [Light<S>],
    /// What rays see that meet nothing.
    pub sky: Sky<S>,
    /// Light that reaches every surface from everywhere.
    pub ambient: Rgb<S>,
    /// What rays from the eye see through on their way, if anything.
    pub volume: Option<&'a Volume<S>>,
}

// Derived, these would ask the user's shape to be `Copy`, though the scene only borrows it.
impl<S: Copy, X> Clone for Scene<'_, S, X> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Copy, X> Copy for Scene<'_, S, X> {}

impl<'a, S: Scalar, X> Scene<'a, S, X> {
    /// Makes a scene with a black sky and no ambient light.
    pub const fn new(
        objects: &'a [Object<S, X>],
        materials: &'a [Material<S>],
        lights: &'a [Light<S>],
    ) -> Self {
        Self { objects, materials, lights, sky: Sky::Solid(Rgb::BLACK), ambient: Rgb::BLACK, volume: None }
    }

    /// Sets the sky.
    pub const fn with_sky(mut self, sky: Sky<S>) -> Self {
        self.sky = sky;
        self
    }

    /// Sets the ambient light.
    pub const fn with_ambient(mut self, ambient: Rgb<S>) -> Self {
        self.ambient = ambient;
        self
    }

    /// Adds a volume.
    pub const fn with_volume(mut self, volume: &'a Volume<S>) -> Self {
        self.volume = Some(volume);
        self
    }
}
