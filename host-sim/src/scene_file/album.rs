//! The images of a description: finds them, reads them, names them.

use super::description::Description;
use super::image::ImageFile;
use super::place::Part;
use super::png_file::{self, MAX_TEXELS, Unreadable};
use super::sky::Sky;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Is an image where a description has it.
struct Use<'a> {
    /// The part of the file that names it.
    part: Part,
    /// A word for what it is for.
    role: &'static str,
    file: &'a mut ImageFile,
}

/// Lists the images of a description in the order of its file.
fn uses(description: &mut Description) -> impl Iterator<Item = Use<'_>> {
    let sky = description.sky.iter_mut().flat_map(Sky::images_mut).map(|image| (Part::Sky, image));
    let materials = description.materials.iter_mut().enumerate().flat_map(|(index, (_, material))| {
        material.images_mut().map(move |image| (Part::Material(index), image))
    });
    let shapes = description.objects.iter_mut().enumerate();
    let objects = shapes.filter_map(|(index, (shape, _))| Some((Part::Object(index), shape.image_mut()?)));
    sky.chain(materials).chain(objects).map(|(part, (role, file))| Use { part, role, file })
}

/// Tells which image cannot be read.
pub(super) struct Missed {
    /// The part of the file that names it.
    pub part: Part,
    /// Its name there.
    pub name: String,
    /// Where it was looked for.
    pub path: PathBuf,
    /// Why it cannot be read.
    pub why: Unreadable,
}

/// Reads the images that a description names, each file once.
///
/// # Errors
/// The first that cannot be read.
pub(super) fn read(description: &mut Description, folder: &Path) -> Result<(), Missed> {
    let mut read = HashMap::new();
    let mut room = MAX_TEXELS;
    for Use { part, file, .. } in uses(description) {
        if let Some(bitmap) = read.get(&file.name) {
            file.bitmap = *bitmap;
            continue;
        }
        let path = folder.join(&file.name);
        let bitmap =
            png_file::read(&path, room).map_err(|why| Missed { part, name: file.name.clone(), path, why })?;
        let [columns, rows] = bitmap.size();
        room -= columns * rows;
        read.insert(file.name.clone(), bitmap);
        file.bitmap = bitmap;
    }
    Ok(())
}

impl Description {
    /// Names the images by a stem and what they are for, `STEM-image.png`, `STEM-image-2.png`; answers each
    /// of them once.
    pub fn name_images(&mut self, stem: &str) -> Vec<ImageFile> {
        let mut named: Vec<ImageFile> = vec![];
        let mut counts: HashMap<&str, usize> = HashMap::new();
        for Use { role, file, .. } in uses(self) {
            if let Some(known) = named.iter().find(|known| known.bitmap == file.bitmap) {
                file.name.clone_from(&known.name);
                continue;
            }
            let count = counts.entry(role).or_default();
            *count += 1;
            file.name = match *count {
                1 => format!("{stem}-{role}.png"),
                count => format!("{stem}-{role}-{count}.png"),
            };
            named.push(file.clone());
        }
        named
    }
}
