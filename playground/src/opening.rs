//! Opening: scenes of files that were handed over, and of texts.

use crate::fault::Fault;
use host_sim::files::Handed;
use host_sim::model::{Options, entry};
use host_sim::scene_file::beside::Beside;
use host_sim::scene_file::{SceneFile, describe};
use host_sim::scenes::{self, Entry};
use host_sim::{nff, obj};
use std::path::Path;

/// Opens a scene file or a model that was handed over, with the files that it names.
///
/// # Errors
/// The first mistake in it, or the file that is missing.
pub fn read(name: &str, files: &Handed) -> Result<Entry, Fault> {
    let path = Path::new(name);
    if obj::is_named(path) {
        return Ok(entry(&obj::plan(files, path, Options::default())?));
    }
    if !nff::is_named(path) && !path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("ron")) {
        return Err(Fault::NotAScene(name.to_owned()));
    }
    let bytes = files.find(path).map_err(|_| Fault::NoFile(name.to_owned()))?;
    Ok(scenes::keep(SceneFile::parse_beside(path, bytes.to_vec(), &[], files)?))
}

/// Opens the text of a file, or of a scene whose images, meshes and voxels it may name.
///
/// # Errors
/// The first mistake in it, or the file that is missing.
pub fn write(text: String, file: Option<String>, of: Option<String>, files: &Handed) -> Result<Entry, Fault> {
    let known = of.as_deref().map_or(Ok(vec![]), |of| belongings(of, files))?;
    let name = file.unwrap_or_else(|| of.as_deref().map_or("scene.ron".to_owned(), text_name));
    Ok(scenes::keep(SceneFile::parse_beside(Path::new(&name), text.into_bytes(), &known, files)?))
}

/// Answers the name of the file that the text of a scene or of a model becomes.
pub fn text_name(scene: &str) -> String {
    Path::new(scene).with_extension("ron").to_string_lossy().into_owned()
}

/// Lists the images, meshes and voxels of a scene of the gallery, or of a model that was handed over.
fn belongings(scene: &str, files: &Handed) -> Result<Vec<Beside>, Fault> {
    let is_model = obj::is_named(Path::new(scene));
    let known = if is_model { Some(read(scene, files)?) } else { scenes::find(scene) };
    let view = known.ok_or_else(|| Fault::UnknownScene(scene.to_owned()))?.double;
    Ok(describe(view)?.name_files(view.name))
}
