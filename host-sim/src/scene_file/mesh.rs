//! Meshes of a scene file: OBJ files, and how they stand in the scene.

use super::mesh_file::{self, MeshFile};
use super::placement::Placement;
use super::ready::{Ready, Unusable};
use super::value::Point;
use crate::bake::Accel;
use crate::bake::steps::Steps;
use crate::model::piece::Packing;
use crate::rounded::Rounded;
use scanray::accel::Every;
use scanray::{Corners as CoreCorners, Normals};
use serde::{Deserialize, Serialize};
use std::fmt::Debug;

/// Is triangles that share their corners, with the hierarchy that finds those of a ray.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    /// The file of the triangles.
    pub file: MeshFile,
    /// Where the file's origin stands; at that of the scene if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<Point>,
    /// What a unit of the file becomes, above 0; 1 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scale: Option<f64>,
    /// Degrees by which it is turned about x, then about y, then about z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn: Option<Point>,
    /// Whether normals of the file are left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flat: Option<bool>,
    /// Degrees up to which edges of corners without normals are rounded; none are if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub smooth: Option<f64>,
    /// How corners are told; in steps of the box around them if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub corners: Option<Corners>,
    /// What finds the triangles of a ray; a tree of boxes if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accel: Option<Accel>,
    /// What the core draws of it, once its file has been read.
    #[serde(skip)]
    pub ready: Option<&'static Ready>,
}

/// Says how corners are told.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Corners {
    /// As they are, 24 bytes each with the normal.
    Exact,
    /// In 65536ths of a box's sides, 10 bytes each with the normal.
    Steps {
        /// The box's corner of the lowest coordinates.
        low: Point,
        /// Lengths of its sides, above 0.
        sides: Point,
    },
}

impl Mesh {
    /// Makes what the core draws of the triangles in its file.
    ///
    /// # Errors
    /// What is wrong with the file or with a field.
    pub(super) fn prepare(&mut self) -> Result<(), Unusable> {
        let mut triangles = self.file.triangles.to_vec();
        if self.flat == Some(true) {
            triangles.as_flattened_mut().iter_mut().for_each(|corner| corner.normal = None);
        }
        let placement = Placement { at: self.at, scale: self.scale, turn: self.turn };
        placement.apply(triangles.as_flattened_mut())?;
        let packing = match self.corners {
            Some(Corners::Exact) => Some(Packing::Exact),
            Some(Corners::Steps { low, sides }) => Some(Packing::Packed(Steps { low, sides })),
            None => None,
        };
        let accel = self.accel.unwrap_or_default();
        let ready = Ready::new(triangles, self.smooth, packing, accel)?;
        self.ready = Some(Box::leak(Box::new(ready)));
        Ok(())
    }

    /// Makes the core's mesh, rounded to a number; it stays in memory as long as the program runs. One that
    /// has not been read has no triangles.
    pub fn in_number<S: Rounded>(&self) -> &'static scanray::Mesh<S> {
        let empty = || scanray::Mesh::new(&[], CoreCorners::Exact(&[]), Normals::Flat, &Every(0));
        Box::leak(Box::new(self.ready.map_or_else(empty, Ready::in_number)))
    }

    /// Takes a mesh of the core, whose file has no name yet; `None` if it cannot be told in a file.
    pub fn of(mesh: &scanray::Mesh<f64>) -> Option<Self> {
        let corners = match mesh.corners {
            CoreCorners::Exact(_) => Corners::Exact,
            CoreCorners::Quantized { low, sides, .. } => {
                Corners::Steps { low: low.to_array(), sides: sides.to_array() }
            }
        };
        let mut words = Self {
            file: MeshFile::of(mesh_file::triangles(mesh)?),
            at: None,
            scale: None,
            turn: None,
            flat: None,
            smooth: None,
            corners: Some(corners),
            accel: None,
            ready: None,
        };
        words.prepare().ok()?;
        Some(words)
    }
}

/// Tells whether two meshes have the same triangles to the bit, in the same order: then they make the same
/// picture, in whichever order their corners are listed and whatever their hierarchies.
pub fn are_alike<S: Rounded + Debug>(a: &scanray::Mesh<S>, b: &scanray::Mesh<S>) -> bool {
    a.triangles.len() == b.triangles.len() && corners(a).eq(corners(b)) && frame(a) == frame(b)
}

/// Answers the box whose steps corners are told in, if they are.
fn frame<S: Rounded>(mesh: &scanray::Mesh<S>) -> Option<[scanray::Vec3<S>; 2]> {
    match mesh.corners {
        CoreCorners::Exact(_) => None,
        CoreCorners::Quantized { low, sides, .. } => Some([low, sides]),
    }
}

/// Lists what there is at the corners of all triangles.
fn corners<S: Rounded + Debug>(mesh: &scanray::Mesh<S>) -> impl Iterator<Item = String> {
    let at = |number: &u16| {
        let number = usize::from(*number);
        let place = match mesh.corners {
            CoreCorners::Exact(places) => format!("{:?}", places.get(number)),
            CoreCorners::Quantized { steps, .. } => format!("{:?}", steps.get(number)),
        };
        let normal = match mesh.normals {
            Normals::Flat => String::new(),
            Normals::Exact(normals) => format!("{:?}", normals.get(number)),
            Normals::Octahedral(points) => format!("{:?}", points.get(number).map(|point| direction(*point))),
        };
        format!("{place} {normal} {:?}", mesh.texture.get(number))
    };
    mesh.triangles.as_flattened().iter().map(at)
}

/// Answers one of the points that name the same direction: on the border of the octahedron's square those on
/// either side of an edge's middle do.
fn direction([u, v]: [i16; 2]) -> [i32; 2] {
    let inner = |this: i16, other: i16| {
        if other.unsigned_abs() == 32_767 { i32::from(this).abs() } else { i32::from(this) }
    };
    [inner(u, v), inner(v, u)]
}
