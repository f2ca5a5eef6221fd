//! The triangles of a scene file's meshes, as OBJ files.

use super::opening::{self, Shut};
use crate::bake::octahedron::unfold;
use crate::bake::steps::Steps;
use crate::files::{Files, Open};
use crate::model::Corner;
use crate::obj;
use scanray::{Corners, Mesh, Normals};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::io::{self, Read};
use std::path::Path;
use std::ptr;

/// Is how many triangles all meshes of a scene may have together: eight times as many as the largest.
pub const MAX_TRIANGLES: usize = 8 * u16::MAX as usize;

/// Is how many bytes all files of meshes may have together.
pub const MAX_BYTES: u64 = 1 << 26;

/// Is the name of an OBJ file, with its triangles once they have been read; before, there are none.
#[derive(Clone, Serialize, Deserialize)]
#[serde(from = "String", into = "String")]
pub struct MeshFile {
    /// Path of the file, from the folder of the scene file if it is relative.
    pub name: String,
    /// The triangles, in the file's units.
    pub triangles: &'static [[Corner; 3]],
}

impl From<String> for MeshFile {
    fn from(name: String) -> Self {
        Self { name, triangles: &[] }
    }
}

impl From<MeshFile> for String {
    fn from(file: MeshFile) -> Self {
        file.name
    }
}

impl PartialEq for MeshFile {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.is_same(other)
    }
}

/// Says how many triangles there are: they would fill pages.
impl fmt::Debug for MeshFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "MeshFile({:?}, {} triangles)", self.name, self.triangles.len())
    }
}

impl MeshFile {
    /// Takes triangles that have no name yet; they stay in memory as long as the program runs.
    pub fn of(triangles: Vec<[Corner; 3]>) -> Self {
        Self { name: String::new(), triangles: triangles.leak() }
    }

    /// Tells whether the triangles are the same ones, not equal ones.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        ptr::eq(self.triangles, other.triangles)
    }
}

/// Tells why a mesh cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unreadable {
    /// The file cannot be opened or read.
    Shut(Shut),
    /// With it the files of the scene's meshes have more than [`MAX_BYTES`].
    TooLarge,
    /// With it the meshes of the scene have more triangles than [`MAX_TRIANGLES`].
    TooMany,
    /// It is no OBJ file, or a broken one: the line, if it is not the whole, and the reader's words.
    Broken(Option<usize>, String),
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shut(shut) => shut.fmt(f),
            Self::TooLarge => {
                write!(f, "the files of a scene's meshes have at most {MAX_BYTES} bytes together")
            }
            Self::TooMany => {
                write!(f, "the meshes of a scene have at most {MAX_TRIANGLES} triangles together")
            }
            Self::Broken(Some(line), why) => write!(f, "line {line}: {why}"),
            Self::Broken(None, why) => f.write_str(why),
        }
    }
}

impl std::error::Error for Unreadable {}

/// Reads the triangles of a file of at most so many bytes, which are counted down; they stay in memory as
/// long as the program runs.
///
/// # Errors
/// What is wrong with it; nothing is read of a file that is too large.
pub fn read(files: &dyn Files, path: &Path, room: &mut u64) -> Result<&'static [[Corner; 3]], Unreadable> {
    let Open { content, bytes: length } = opening::open(files, path).map_err(Unreadable::Shut)?;
    if length > *room {
        return Err(Unreadable::TooLarge);
    }
    let mut bytes = vec![];
    let read = content.take(length).read_to_end(&mut bytes);
    read.map_err(|error| Unreadable::Shut(Shut::Withheld(error.kind())))?;
    *room -= length;
    // Letters that are not UTF-8 stand in names, which are left out.
    let triangles = obj::surfaces(path, &String::from_utf8_lossy(&bytes));
    let triangles =
        triangles.map_err(|mistake| Unreadable::Broken(mistake.line, mistake.reason.to_string()))?;
    Ok(triangles.leak())
}

/// Writes triangles as a file that is read back to the bit.
///
/// # Errors
/// What the file system says.
pub fn write(path: &Path, file: &MeshFile) -> io::Result<()> {
    std::fs::write(path, obj::write(file.triangles))
}

/// Lists the triangles of a mesh of the core; `None` if one names a corner that is not there.
pub(super) fn triangles(mesh: &Mesh<f64>) -> Option<Vec<[Corner; 3]>> {
    let corner = |number: u16| {
        let number = usize::from(number);
        let place = match mesh.corners {
            Corners::Exact(places) => places.get(number)?.to_array(),
            Corners::Quantized { low, sides, steps } => {
                Steps { low: low.to_array(), sides: sides.to_array() }.place(*steps.get(number)?)
            }
        };
        let normal = match mesh.normals {
            Normals::Flat => None,
            Normals::Exact(normals) => Some(normals.get(number)?.to_array()),
            Normals::Octahedral(points) => Some(unfold(*points.get(number)?)),
        };
        Some(Corner { place, normal, texture: mesh.texture.get(number).copied() })
    };
    let triangle = |[a, b, c]: &[u16; 3]| Some([corner(*a)?, corner(*b)?, corner(*c)?]);
    mesh.triangles.iter().map(triangle).collect()
}
