//! Files that lie beside a scene file: how they are named and written.

use super::image::ImageFile;
use super::mesh_file::{self, MeshFile};
use super::png_file;
use super::voxel_file::{self, VoxelFile};
use std::collections::HashMap;
use std::io;
use std::path::Path;

/// Is a file beside a scene file, with what it holds.
#[derive(Clone, Debug)]
pub enum Beside {
    /// Texels, as a PNG file.
    Image(ImageFile),
    /// Triangles, as an OBJ file.
    Mesh(MeshFile),
    /// Voxels, a byte each.
    Voxels(VoxelFile),
}

impl Beside {
    /// Answers a word for what it is.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Image(_) => "image",
            Self::Mesh(_) => "mesh",
            Self::Voxels(_) => "voxels",
        }
    }

    /// Answers its path, from the folder of the scene file if it is relative.
    pub fn name(&self) -> &str {
        match self {
            Self::Image(image) => &image.name,
            Self::Mesh(mesh) => &mesh.name,
            Self::Voxels(voxels) => &voxels.name,
        }
    }

    /// Writes it such that it is read back to the bit.
    ///
    /// # Errors
    /// What the file system says.
    pub fn write(&self, path: &Path) -> io::Result<()> {
        match self {
            Self::Image(image) => png_file::write(path, &image.bitmap),
            Self::Mesh(mesh) => mesh_file::write(path, mesh),
            Self::Voxels(voxels) => voxel_file::write(path, &voxels.voxels),
        }
    }
}

/// Names files by a stem, what they are for and an ending, `STEM-image.png`, `STEM-image-2.png`; answers each
/// of them once.
pub(super) fn name_each<'a, F: Clone + 'a>(
    uses: impl Iterator<Item = (&'static str, &'a mut F)>,
    [stem, ending]: [&str; 2],
    name: fn(&mut F) -> &mut String,
    is_same: fn(&F, &F) -> bool,
) -> Vec<F> {
    let mut named: Vec<F> = vec![];
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for (role, file) in uses {
        if let Some(known) = named.iter_mut().find(|known| is_same(known, file)) {
            name(file).clone_from(name(known));
            continue;
        }
        let count = counts.entry(role).or_default();
        *count += 1;
        *name(file) = match *count {
            1 => format!("{stem}-{role}.{ending}"),
            count => format!("{stem}-{role}-{count}.{ending}"),
        };
        named.push(file.clone());
    }
    named
}
