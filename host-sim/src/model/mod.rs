//! Models: triangles without a camera, a light or a unit, and their way to a scene of the core.
//!
//! - [`Model`]: what a reader of a format hands over. [`paint`]: what its surfaces do with light.
//! - [`smooth`]: normals for triangles that have none; [`place`]: the unit and the place that suit every
//!   number.
//! - [`piece`]: corners that triangles share, no more of either than a mesh can number; [`mod@mesh`]: the
//!   core's mesh of them, with its hierarchy.
//! - [`view`]: camera and light that show it; [`mod@plant`]: the scene.

pub mod mesh;
pub mod paint;
pub mod piece;
pub mod place;
pub mod plant;
pub mod smooth;
pub mod vector;
pub mod view;

pub use paint::Paint;
pub use plant::{Options, Plan, entry};

use crate::bake::Bounds;

/// Is a corner of a triangle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Corner {
    /// Where it is.
    pub place: [f64; 3],
    /// The surface's outward direction there, of any length, if it is given.
    pub normal: Option<[f64; 3]>,
    /// Texture coordinates u and v, if they are given.
    pub texture: Option<[f64; 2]>,
}

/// Is the triangles of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Place of the material in the model's list.
    pub material: usize,
    /// Corners of each, anticlockwise as seen from outside.
    pub triangles: Vec<[Corner; 3]>,
}

/// Is triangles with their materials, in the file's units.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// The name: that of its file without its ending.
    pub name: String,
    /// The triangles by material.
    pub parts: Vec<Part>,
    /// The materials.
    pub paints: Vec<Paint>,
}

impl Model {
    /// Answers the box around all corners.
    pub fn bounds(&self) -> Bounds {
        let triangles = self.parts.iter().flat_map(|part| &part.triangles);
        Bounds::around(triangles.flatten().map(|corner| corner.place))
    }

    /// Counts the triangles.
    pub fn count(&self) -> usize {
        self.parts.iter().map(|part| part.triangles.len()).sum()
    }
}
