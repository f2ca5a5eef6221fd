//! Scenes by name: the gallery's views, and those of files, with the number chosen at run time.

use crate::rounded::Rounded;
use crate::scene_file::description::Lists;
use crate::scene_file::{Failure, SceneFile};
use crate::suggest;
use scanray::Fixed;
use scanray::gallery::{Gallery, View};
use std::path::Path;

/// Is a scene of the gallery or of a file, in every number.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The scene in `f32`.
    pub float: &'static View<f32>,
    /// The scene in fixed point.
    pub fixed: &'static View<Fixed>,
    /// The scene in `f64`.
    pub double: &'static View<f64>,
    /// The file it comes from; none for the gallery.
    pub file: Option<&'static SceneFile>,
}

impl Entry {
    /// Answers the name, as commands take it.
    pub fn name(&self) -> &'static str {
        self.double.name
    }
}

/// Lists the gallery.
pub fn all() -> impl Iterator<Item = Entry> {
    let numbers = f32::views().iter().zip(Fixed::views()).zip(f64::views());
    numbers.map(|((float, fixed), double)| Entry { float, fixed, double, file: None })
}

/// Finds a scene by its name.
pub fn find(name: &str) -> Option<Entry> {
    all().find(|entry| entry.name() == name)
}

/// Answers the name that is most like a misspelt one, if any is like it at all.
pub fn nearest(name: &str) -> Option<&'static str> {
    suggest::nearest(name, all().map(|entry| entry.name()))
}

/// Reads the scene of a file.
///
/// It stays in memory as long as the program runs, as those of the gallery do: a command draws few scenes.
///
/// # Errors
/// What is wrong with the file.
pub fn read(path: &Path) -> Result<Entry, Failure> {
    SceneFile::read(path).map(keep)
}

/// Makes a scene of a file that has been read, to stay in memory as those of [`read`] do.
pub fn keep(file: SceneFile) -> Entry {
    let file: &'static SceneFile = Box::leak(Box::new(file));
    Entry { float: kept(file), fixed: kept(file), double: kept(file), file: Some(file) }
}

/// Rounds the scene of a file to a number, to stay in memory.
fn kept<S: HostNumber>(file: &'static SceneFile) -> &'static View<S> {
    let description = file.drawn();
    let lists: &'static Lists<S> = Box::leak(Box::new(description.lists()));
    let (camera, settings) = (description.camera.in_number(), description.settings.in_number());
    let scene = description.scene(lists);
    let about = if description.about.is_empty() { "a scene of its own" } else { &description.about };
    let view = View { name: file.name(), about, scene, camera, settings, size: description.size };
    Box::leak(Box::new(view))
}

/// Is a number that the core draws the gallery in.
pub trait HostNumber: Rounded + Send + Sync {
    /// Answers the scene in this number.
    fn view(entry: &Entry) -> &'static View<Self>;
}

impl HostNumber for f32 {
    fn view(entry: &Entry) -> &'static View<Self> {
        entry.float
    }
}

impl HostNumber for Fixed {
    fn view(entry: &Entry) -> &'static View<Self> {
        entry.fixed
    }
}

impl HostNumber for f64 {
    fn view(entry: &Entry) -> &'static View<Self> {
        entry.double
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rounded::camera_in;

    #[test]
    fn every_number_has_the_same_scenes_in_the_same_order() {
        for entry in all() {
            assert_eq!(entry.float.name, entry.double.name);
            assert_eq!(entry.fixed.name, entry.double.name);
        }
        assert_eq!(all().count(), f64::views().len());
    }

    #[test]
    fn a_camera_rounded_from_f64_is_the_one_of_the_gallery() {
        for entry in all() {
            assert_eq!(camera_in::<f32>(&entry.double.camera), entry.float.camera, "{}", entry.name());
            assert_eq!(camera_in::<Fixed>(&entry.double.camera), entry.fixed.camera, "{}", entry.name());
        }
    }

    #[test]
    fn a_misspelt_name_finds_its_scene_and_nonsense_finds_none() {
        assert_eq!(nearest("simpel"), Some("simple"));
        assert_eq!(nearest("Three-Sphere"), Some("three-spheres"));
        assert_eq!(nearest("tiny"), Some("tinyraytracer"));
        assert_eq!(nearest("zzzzzzzz"), None);
    }
}
