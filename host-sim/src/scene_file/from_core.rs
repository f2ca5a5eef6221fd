//! From a view of the core to its description.

use super::camera::Camera;
use super::description::Description;
use super::light::Light;
use super::material::Material;
use super::mesh::are_alike;
use super::names::names;
use super::settings::Settings;
use super::shape::Shape;
use super::sky::Sky;
use super::value::{Color, unless};
use super::volume::Volume;
use scanray::gallery::View;
use scanray::{Scene, Shape as CoreShape};
use std::fmt;

/// Names the thing of a view that scene files have no words for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unsayable {
    /// An object.
    Object(usize),
    /// A material.
    Material(usize),
    /// A light.
    Light(usize),
    /// The sky.
    Sky,
    /// The camera.
    Camera,
    /// The settings.
    Settings,
    /// The volume.
    Volume,
}

impl fmt::Display for Unsayable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("scene files have no words for ")?;
        match self {
            Self::Object(index) => write!(f, "object {index}"),
            Self::Material(index) => write!(f, "material {index}"),
            Self::Light(index) => write!(f, "light {index}"),
            Self::Sky => f.write_str("the sky"),
            Self::Camera => f.write_str("the camera"),
            Self::Settings => f.write_str("the settings"),
            Self::Volume => f.write_str("the volume"),
        }
    }
}

impl std::error::Error for Unsayable {}

/// Answers the words for a thing of the core, if they bring back that very thing.
///
/// The core's enums and structs are open to its future: words that forget something new are caught here.
fn say<W, C: PartialEq>(words: Option<W>, back: impl Fn(&W) -> C, core: &C) -> Option<W> {
    words.filter(|words| back(words) == *core)
}

/// Describes a view of the core; its files are named by the view's name.
///
/// # Errors
/// The first thing that a scene file would not bring back as it is.
pub fn describe(view: &View<f64>) -> Result<Description, Unsayable> {
    let scene = &view.scene;
    let unlit = Scene::<f64>::new(&[], &[], &[]);
    let camera = say(Camera::of(&view.camera), Camera::in_number, &view.camera);
    let settings = say(Some(Settings::of(&view.settings)), Settings::in_number, &view.settings);
    let sky = say(Sky::of(&scene.sky), Sky::in_number, &scene.sky).ok_or(Unsayable::Sky)?;
    let materials = each(scene.materials, Unsayable::Material, |material| {
        say(Material::of(material), Material::in_number, material)
    })?;
    let mut description = Description {
        about: view.about.to_owned(),
        size: view.size,
        camera: camera.ok_or(Unsayable::Camera)?,
        settings: settings.ok_or(Unsayable::Settings)?,
        sky: (scene.sky != unlit.sky).then_some(sky),
        ambient: unless(unlit.ambient, scene.ambient).map(Color::of),
        materials: names(&materials).into_iter().zip(materials).collect(),
        lights: each(scene.lights, Unsayable::Light, |light| say(Light::of(light), Light::in_number, light))?,
        objects: each(scene.objects, Unsayable::Object, |object| {
            Some((say_shape(&object.shape)?, object.material))
        })?,
        volume: match scene.volume {
            Some(volume) => {
                let words = say(Some(Volume::of(volume)), Volume::in_number, volume);
                Some(words.ok_or(Unsayable::Volume)?)
            }
            None => None,
        },
    };
    description.name_files(view.name);
    Ok(description)
}

/// Answers the words for a shape, as [`say`] does: a mesh is another one each time it is made.
fn say_shape(shape: &CoreShape<f64>) -> Option<Shape> {
    Shape::of(shape).filter(|words| match (words.in_number(), shape) {
        (CoreShape::Mesh(back), CoreShape::Mesh(core)) => are_alike(back, core),
        (back, core) => back == *core,
    })
}

/// Finds words for everything in a list, or names the first thing that there are none for.
fn each<C, W>(
    list: &[C],
    unsayable: fn(usize) -> Unsayable,
    words: impl Fn(&C) -> Option<W>,
) -> Result<Vec<W>, Unsayable> {
    list.iter().enumerate().map(|(index, thing)| words(thing).ok_or(unsayable(index))).collect()
}
