//! Files that lie beside a scene file: how they are opened, named and written.

use super::image::ImageFile;
use super::mesh_file::{self, MeshFile};
use super::png_file;
use super::voxel_file::{self, VoxelFile};
use crate::files::{Files, Open};
use crate::suggest::nearest;
use std::collections::HashMap;
use std::fmt;
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

/// Tells why a file is not open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shut {
    /// There is no such file; one in its folder whose name is like it.
    Missing(Option<String>),
    /// It is a directory or a device.
    NotAFile,
    /// The system does not hand it out.
    Withheld(io::ErrorKind),
}

impl fmt::Display for Shut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing(None) => f.write_str("there is no such file"),
            Self::Missing(Some(meant)) => write!(f, "there is no such file, did you mean `{meant}`?"),
            Self::NotAFile => f.write_str("it is no file"),
            Self::Withheld(kind) => kind.fmt(f),
        }
    }
}

/// Opens a file.
///
/// # Errors
/// Why it cannot be opened.
pub(super) fn open<'a>(files: &'a dyn Files, path: &Path) -> Result<Open<'a>, Shut> {
    let shut = |error: io::Error| match error.kind() {
        io::ErrorKind::NotFound => Shut::Missing(meant(files, path)),
        other => Shut::Withheld(other),
    };
    files.open(path).map_err(shut)?.ok_or(Shut::NotAFile)
}

/// Answers the file beside a missing one whose name is like its.
fn meant(files: &dyn Files, path: &Path) -> Option<String> {
    let names = files.beside(path);
    nearest(path.file_name()?.to_str()?, names.iter().map(String::as_str)).map(str::to_owned)
}
