//! Grids of voxels in a scene file, and the surfaces in them.

use super::value::{Point, point, unless};
use super::voxel_file::VoxelFile;
use crate::rounded::Rounded;
use serde::{Deserialize, Serialize};

/// Is a grid of voxels in the scene; its fields are those of the core's grid, and the file of the values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Grid {
    /// The file of the values.
    pub file: VoxelFile,
    /// How many voxels there are along x, y and z, 2 to 1024 each.
    pub size: [u16; 3],
    /// Where the first voxel stands.
    pub low: Point,
    /// Distance from voxel to voxel along each axis, at least 1/1024.
    pub spacing: Point,
}

impl Grid {
    /// Makes the core's grid, rounded to a number.
    pub fn in_number<S: Rounded>(&self) -> scanray::Grid<S> {
        scanray::Grid::new(self.file.voxels, point(self.low), point(self.spacing))
    }

    /// Takes a grid of the core.
    pub fn of(grid: &scanray::Grid<f64>) -> Self {
        let [low, spacing] = [grid.low, grid.spacing].map(scanray::Vec3::to_array);
        Self { file: VoxelFile::of(grid.voxels), size: grid.voxels.sides(), low, spacing }
    }
}

/// Names by differences of which order normals are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Gradient {
    /// Those of neighbouring voxels.
    First,
    /// Central ones.
    Second,
}

impl Gradient {
    /// Makes the core's.
    pub fn in_core(self) -> scanray::Gradient {
        match self {
            Self::First => scanray::Gradient::First,
            Self::Second => scanray::Gradient::Second,
        }
    }

    /// Takes one of the core.
    pub fn of(gradient: scanray::Gradient) -> Self {
        match gradient {
            scanray::Gradient::First => Self::First,
            scanray::Gradient::Second => Self::Second,
        }
    }
}

/// Is the surface in a sampled field; its fields are those of the core's shape of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Isosurface {
    /// The field.
    pub grid: Grid,
    /// Its value on the surface, from 0 to 255.
    pub level: f64,
    /// How normals are found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gradient: Option<Gradient>,
}

impl Isosurface {
    /// Makes the core's shape, rounded to a number; its grid stays in memory as long as the program runs.
    pub fn in_number<S: Rounded>(&self) -> scanray::Isosurface<S> {
        let surface =
            scanray::Isosurface::new(Box::leak(Box::new(self.grid.in_number())), S::round(self.level));
        scanray::Isosurface { gradient: self.gradient.map_or(surface.gradient, Gradient::in_core), ..surface }
    }

    /// Takes a shape of the core.
    pub fn of(surface: &scanray::Isosurface<f64>) -> Self {
        let usual = scanray::Isosurface::new(surface.grid, surface.level);
        Self {
            grid: Grid::of(surface.grid),
            level: surface.level,
            gradient: unless(usual.gradient, surface.gradient).map(Gradient::of),
        }
    }
}
