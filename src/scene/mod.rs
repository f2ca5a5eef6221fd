//! The scene: what there is to see, as a view of slices that may live in flash.

mod buffer;
mod check;
mod extent;

pub use buffer::{Full, SceneBuffer};
pub use check::SceneError;

use crate::accel::Hierarchy;
use crate::color::Rgb;
use crate::environment::Sky;
use crate::light::Light;
use crate::material::Material;
use crate::math::Scalar;
use crate::shape::Shape;
use crate::volume::Volume;
use core::convert::Infallible;
use core::ops::Range;
use core::ptr;

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
#[derive(Debug)]
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
    /// Which of the first so many objects a ray may meet, as many as it holds; those behind them in the list are
    /// asked one by one. Without it, all are.
    pub hierarchy: Option<&'a dyn Hierarchy<S>>,
    /// What rays from the eye see through on their way, if anything.
    pub volume: Option<&'a Volume<S>>,
}

/// Is the same hierarchy, not an equal one.
impl<S: PartialEq, X: PartialEq> PartialEq for Scene<'_, S, X> {
    fn eq(&self, other: &Self) -> bool {
        let address = |scene: &Self| scene.hierarchy.map(|hierarchy| ptr::from_ref(hierarchy).cast::<()>());
        (self.objects, self.materials, self.lights) == (other.objects, other.materials, other.lights)
            && (self.sky == other.sky && self.ambient == other.ambient)
            && self.volume == other.volume
            && address(self) == address(other)
    }
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
        let (sky, ambient) = (Sky::Solid(Rgb::BLACK), Rgb::BLACK);
        Self { objects, materials, lights, sky, ambient, hierarchy: None, volume: None }
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

    /// Sets the hierarchy over the first objects, those that it holds.
    pub const fn with_hierarchy(mut self, hierarchy: &'a dyn Hierarchy<S>) -> Self {
        self.hierarchy = Some(hierarchy);
        self
    }

    /// Answers the hierarchy, if this program was built with any.
    pub(crate) fn tree(&self) -> Option<&'a dyn Hierarchy<S>> {
        if cfg!(feature = "meshes") { self.hierarchy } else { None }
    }

    /// Answers the places of the objects that are asked one by one.
    pub(crate) fn loose(&self) -> Range<u16> {
        let end = u16::try_from(self.objects.len()).unwrap_or(u16::MAX);
        self.tree().map_or(0, |tree| tree.count()).min(end)..end
    }

    /// Adds a volume.
    pub const fn with_volume(mut self, volume: &'a Volume<S>) -> Self {
        self.volume = Some(volume);
        self
    }
}
