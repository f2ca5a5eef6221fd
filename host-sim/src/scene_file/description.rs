//! A scene as a file describes it, in `f64`, and its way to the core and back.

use super::camera::Camera;
use super::light::Light;
use super::material::Material;
use super::settings::Settings;
use super::shape::Shape;
use super::sky::Sky;
use super::value::Color;
use super::volume::Volume;
use crate::picture::MAX_DEPTH;
use crate::rounded::Rounded;
use embedded_graphics_core::geometry::Size;
use scanray::{Object, RenderError, Renderer, Scene, Workspace};

/// Is the size of a picture where a file does not say it.
pub const SIZE: [u32; 2] = [320, 240];

/// Is all that a scene file says.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// What the scene shows, in a sentence or two.
    pub about: String,
    /// Columns and rows of the usual picture.
    pub size: [u32; 2],
    /// Where it is seen from.
    pub camera: Camera,
    /// How the picture is made.
    pub settings: Settings,
    /// What rays see that meet nothing; black if not given.
    pub sky: Option<Sky>,
    /// Light that reaches every surface from everywhere; none if not given.
    pub ambient: Option<Color>,
    /// What objects are made of, by name.
    pub materials: Vec<(String, Material)>,
    /// Where light comes from.
    pub lights: Vec<Light>,
    /// Shapes with the places of their materials.
    pub objects: Vec<(Shape, u16)>,
    /// A body that light comes through; none if not given.
    pub volume: Option<Volume>,
}

/// Holds the lists of a scene in a number, for the scene to borrow.
#[derive(Clone, Debug)]
pub struct Lists<S: 'static> {
    objects: Vec<Object<S>>,
    materials: Vec<scanray::Material<S>>,
    lights: Vec<scanray::Light<S>>,
    volume: Option<scanray::Volume<S>>,
}

impl Description {
    /// Rounds the lists to a number, as the gallery's constants are rounded.
    pub fn lists<S: Rounded>(&self) -> Lists<S> {
        Lists {
            objects: self.objects.iter().map(|(shape, of)| Object::new(shape.in_number(), *of)).collect(),
            materials: self.materials.iter().map(|(_, material)| material.in_number()).collect(),
            lights: self.lights.iter().map(Light::in_number).collect(),
            volume: self.volume.as_ref().map(Volume::in_number),
        }
    }

    /// Makes the core's scene of lists of the same number.
    pub fn scene<'a, S: Rounded>(&self, lists: &'a Lists<S>) -> Scene<'a, S> {
        let mut scene = Scene::new(&lists.objects, &lists.materials, &lists.lights);
        scene.sky = self.sky.as_ref().map_or(scene.sky, Sky::in_number);
        scene.ambient = self.ambient.map_or(scene.ambient, Color::in_number);
        scene.volume = lists.volume.as_ref();
        scene
    }

    /// Answers what keeps the core from drawing it in `f64`, if anything does.
    pub fn refusal(&self) -> Option<RenderError> {
        let lists = self.lists::<f64>();
        let mut workspace = Workspace::<f64, [u8; 2], 0, MAX_DEPTH>::new();
        let (scene, camera, settings) =
            (self.scene(&lists), self.camera.in_number(), self.settings.in_number());
        let [columns, rows] = self.size;
        Renderer::new(&scene, &camera, Size::new(columns, rows), settings, &mut workspace).err()
    }
}
