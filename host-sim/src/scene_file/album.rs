//! The files of a description: finds them, reads them, names them.

use super::beside::{Beside, name_each};
use super::description::Description;
use super::grid::Grid;
use super::image::ImageFile;
use super::mesh::Mesh;
use super::mistake::Reason;
use super::place::Part;
use super::sky::Sky;
use super::{mesh_file, png_file, voxel_file};
use crate::files::Files;
use std::collections::HashMap;
use std::path::Path;

/// Lists the images of a description, each with the part of the file that names it and a word for what it is
/// for.
fn images(description: &mut Description) -> impl Iterator<Item = (Part, (&'static str, &mut ImageFile))> {
    let sky = description.sky.iter_mut().flat_map(Sky::images_mut).map(|image| (Part::Sky, image));
    let materials = description.materials.iter_mut().enumerate().flat_map(|(index, (_, material))| {
        material.images_mut().map(move |image| (Part::Material(index), image))
    });
    let shapes = description.objects.iter_mut().enumerate();
    let objects = shapes.filter_map(|(index, (shape, _))| Some((Part::Object(index), shape.image_mut()?)));
    sky.chain(materials).chain(objects)
}

/// Lists the meshes of a description.
fn meshes(description: &mut Description) -> impl Iterator<Item = (Part, &mut Mesh)> {
    let shapes = description.objects.iter_mut().enumerate();
    shapes.filter_map(|(index, (shape, _))| Some((Part::Object(index), shape.mesh_mut()?)))
}

/// Lists the grids of voxels of a description.
fn grids(description: &mut Description) -> impl Iterator<Item = (Part, &mut Grid)> {
    let shapes = description.objects.iter_mut().enumerate();
    let objects = shapes.filter_map(|(index, (shape, _))| Some((Part::Object(index), shape.grid_mut()?)));
    objects.chain(description.volume.iter_mut().map(|volume| (Part::Volume, &mut volume.grid)))
}

/// Tells which file cannot be read.
pub(super) struct Missed {
    /// The part of the scene file that names it.
    pub part: Part,
    /// Its name there; empty if it is not the file that is wrong.
    pub name: String,
    /// What is wrong with it.
    pub reason: Reason,
}

/// Is where the files of a description are.
#[derive(Clone, Copy)]
pub(super) struct Shelf<'a> {
    /// The folder of the scene file.
    pub folder: &'a Path,
    /// What it is a folder of.
    pub files: &'a dyn Files,
    /// Files whose content is already known.
    pub known: &'a [Beside],
}

/// Reads the files that a description names, each once, and none of those that are already known.
///
/// # Errors
/// The first that cannot be read.
pub(super) fn read(description: &mut Description, shelf: Shelf<'_>) -> Result<(), Missed> {
    read_images(description, shelf)?;
    read_meshes(description, shelf)?;
    read_voxels(description, shelf)
}

fn read_images(description: &mut Description, shelf: Shelf<'_>) -> Result<(), Missed> {
    let mut read = HashMap::new();
    for beside in shelf.known {
        if let Beside::Image(file) = beside {
            read.insert(file.name.clone(), file.bitmap);
        }
    }
    let mut room = png_file::MAX_TEXELS;
    for (part, (_, file)) in images(description) {
        if let Some(bitmap) = read.get(&file.name) {
            file.bitmap = *bitmap;
            continue;
        }
        let path = shelf.folder.join(&file.name);
        let missed =
            |why| Missed { part, name: file.name.clone(), reason: Reason::Image { path: path.clone(), why } };
        let bitmap = png_file::read(shelf.files, &path, room).map_err(missed)?;
        let [columns, rows] = bitmap.size();
        room -= columns * rows;
        read.insert(file.name.clone(), bitmap);
        file.bitmap = bitmap;
    }
    Ok(())
}

fn read_meshes(description: &mut Description, shelf: Shelf<'_>) -> Result<(), Missed> {
    let mut read = HashMap::new();
    for beside in shelf.known {
        if let Beside::Mesh(file) = beside {
            read.insert(file.name.clone(), file.triangles);
        }
    }
    let (mut room, mut triangles_left) = (mesh_file::MAX_BYTES, mesh_file::MAX_TRIANGLES);
    for (part, mesh) in meshes(description) {
        let name = mesh.file.name.clone();
        let path = shelf.folder.join(&name);
        let missed =
            |why| Missed { part, name: name.clone(), reason: Reason::Mesh { path: path.clone(), why } };
        mesh.file.triangles = match read.get(&name) {
            Some(known) => *known,
            None => mesh_file::read(shelf.files, &path, &mut room).map_err(missed)?,
        };
        read.insert(name.clone(), mesh.file.triangles);
        let left = triangles_left.checked_sub(mesh.file.triangles.len());
        triangles_left = left.ok_or(mesh_file::Unreadable::TooMany).map_err(missed)?;
        let unusable = |why| Missed { part, name: String::new(), reason: Reason::Unusable(why) };
        mesh.prepare().map_err(unusable)?;
    }
    Ok(())
}

fn read_voxels(description: &mut Description, shelf: Shelf<'_>) -> Result<(), Missed> {
    let mut read = HashMap::new();
    for beside in shelf.known {
        if let Beside::Voxels(file) = beside {
            read.insert((file.name.clone(), file.voxels.sides()), file.voxels);
        }
    }
    let mut room = voxel_file::MAX_VOXELS;
    for (part, Grid { file, size, .. }) in grids(description) {
        let key = (file.name.clone(), *size);
        if let Some(voxels) = read.get(&key) {
            file.voxels = *voxels;
            continue;
        }
        let path = shelf.folder.join(&file.name);
        let missed = |why| Missed {
            part,
            name: file.name.clone(),
            reason: Reason::Voxels { path: path.clone(), why },
        };
        let voxels = voxel_file::read(shelf.files, &path, *size, room).map_err(missed)?;
        room -= voxel_file::count(*size);
        read.insert(key, voxels);
        file.voxels = voxels;
    }
    Ok(())
}

impl Description {
    /// Names the files beside the scene's by a stem and what they are for, `STEM-image.png`, `STEM-mesh.obj`,
    /// `STEM-mesh-2.obj`; answers each of them once.
    pub fn name_files(&mut self, stem: &str) -> Vec<Beside> {
        let pictures = images(self).map(|(_, image)| image);
        let pictures = name_each(pictures, [stem, "png"], |file| &mut file.name, |a, b| a.bitmap == b.bitmap);
        let bodies = meshes(self).map(|(_, mesh)| ("mesh", &mut mesh.file));
        let bodies = name_each(bodies, [stem, "obj"], |file| &mut file.name, |a, b| a.is_same(b));
        let fields = grids(self).map(|(_, grid)| ("voxels", &mut grid.file));
        let fields = name_each(fields, [stem, "raw"], |file| &mut file.name, |a, b| a.voxels == b.voxels);
        let pictures = pictures.into_iter().map(Beside::Image);
        pictures
            .chain(bodies.into_iter().map(Beside::Mesh))
            .chain(fields.into_iter().map(Beside::Voxels))
            .collect()
    }
}
