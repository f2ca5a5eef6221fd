//! The voxels of a scene file, as files of bytes: the value of each voxel, x running fastest, then y, then z,
//! and nothing else.

use super::opening::{self, Shut};
use crate::files::{Files, Open};
use scanray::Voxels;
use serde::{Deserialize, Serialize};
use std::io::{self, Read};
use std::path::Path;
use std::{fmt, fs};

/// Is how many voxels all grids of a scene may have together: those of one with 512 along each side.
pub const MAX_VOXELS: u64 = 1 << 27;

/// Is the name of a file of voxels, with their values once they have been read; before, there are none, and
/// the core refuses the grid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "String", into = "String")]
pub struct VoxelFile {
    /// Path of the file, from the folder of the scene file if it is relative.
    pub name: String,
    /// The values.
    pub voxels: Voxels,
}

impl From<String> for VoxelFile {
    fn from(name: String) -> Self {
        Self { name, voxels: Voxels::new([0; 3], &[]) }
    }
}

impl From<VoxelFile> for String {
    fn from(file: VoxelFile) -> Self {
        file.name
    }
}

impl VoxelFile {
    /// Takes voxels of the core, which have no name yet.
    pub fn of(voxels: Voxels) -> Self {
        Self { name: String::new(), voxels }
    }
}

/// Tells why voxels cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unreadable {
    /// The file cannot be opened or read.
    Shut(Shut),
    /// A side has fewer than 2 voxels, or more than [`Voxels::LARGEST`].
    Size,
    /// With them the grids of the scene have more than [`MAX_VOXELS`].
    TooMany,
    /// The file has not a byte for each voxel.
    Length {
        /// How many bytes it has.
        bytes: u64,
        /// How many voxels there are to be.
        voxels: u64,
    },
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shut(shut) => shut.fmt(f),
            Self::Size => write!(f, "`size` is 2 to {} voxels along each side", Voxels::LARGEST),
            Self::TooMany => write!(f, "the grids of a scene have at most {MAX_VOXELS} voxels together"),
            Self::Length { bytes, voxels } => {
                write!(f, "it has {bytes} bytes, and `size` asks for {voxels}, one a voxel")
            }
        }
    }
}

impl std::error::Error for Unreadable {}

/// Reads a grid of at most so many voxels, and works out its blocks; it stays in memory as long as the
/// program runs.
///
/// # Errors
/// What is wrong with it; nothing is read of a file whose length is not the right one.
pub fn read(files: &dyn Files, path: &Path, size: [u16; 3], most_voxels: u64) -> Result<Voxels, Unreadable> {
    let Open { content, bytes } = opening::open(files, path).map_err(Unreadable::Shut)?;
    if !size.iter().all(|side| (2..=Voxels::LARGEST).contains(side)) {
        return Err(Unreadable::Size);
    }
    let voxels = count(size);
    if voxels > most_voxels {
        return Err(Unreadable::TooMany);
    }
    let wrong_length = |bytes| Unreadable::Length { bytes, voxels };
    if bytes != voxels {
        return Err(wrong_length(bytes));
    }
    let mut values = vec![];
    let read = content.take(voxels).read_to_end(&mut values);
    read.map_err(|error| Unreadable::Shut(Shut::Withheld(error.kind())))?;
    if values.len() as u64 != voxels {
        return Err(wrong_length(values.len() as u64));
    }
    let plain = Voxels::new(size, values.leak());
    let blocks: Vec<u8> = places(plain.block_sides()).flat_map(|block| plain.extremes(block)).collect();
    Ok(plain.with_blocks(blocks.leak()))
}

/// Counts the voxels of a grid.
pub(super) fn count(size: [u16; 3]) -> u64 {
    size.into_iter().map(u64::from).product()
}

/// Writes voxels as a file that is read back to the bit.
///
/// # Errors
/// What the file system says.
pub fn write(path: &Path, voxels: &Voxels) -> io::Result<()> {
    let values: Vec<u8> = places(voxels.sides()).map(|voxel| voxels.value(voxel)).collect();
    fs::write(path, values)
}

/// Lists the places of a grid, x fastest.
fn places([columns, rows, slices]: [u16; 3]) -> impl Iterator<Item = [u16; 3]> {
    (0..slices).flat_map(move |z| (0..rows).flat_map(move |y| (0..columns).map(move |x| [x, y, z])))
}
