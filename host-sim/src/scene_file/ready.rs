//! What the core draws of a mesh's triangles, for every number.

use crate::bake::steps::Steps;
use crate::bake::{Accel, Bounds, Built};
use crate::model::piece::{Packing, Piece, pieces};
use crate::model::smooth::smooth;
use crate::model::{Corner, Model, Part, mesh};
use crate::rounded::Rounded;
use std::{fmt, ptr};

/// Is how many triangles, and how many corners, a mesh can number.
pub const MOST: usize = u16::MAX as usize;

/// Is how many triangles `kd`, `octree` and `grid` take: each may name one many times.
pub const MOST_IN_CELLS: usize = 1 << 14;

/// Is corners that triangles share, and the hierarchy over these.
pub struct Ready {
    piece: Piece,
    packing: Packing,
    built: Built,
    bounds: Bounds,
}

/// Is the same, not one of equal triangles.
impl PartialEq for Ready {
    fn eq(&self, other: &Self) -> bool {
        ptr::eq(self, other)
    }
}

/// Says how large it is: its lists would fill pages.
impl fmt::Debug for Ready {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Ready({} triangles, {} corners)", self.piece.triangles.len(), self.piece.places.len())
    }
}

/// Tells why triangles make no mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unusable {
    /// No triangle has an area.
    Nothing,
    /// There are more triangles or corners than [`MOST`].
    TooMany,
    /// There are more triangles than [`MOST_IN_CELLS`], and the hierarchy names them by cells.
    TooManyForCells,
    /// The scale is not above 0, or too large.
    Scale,
    /// The place or the turn is no number, or too large.
    TooLarge,
    /// The angle up to which edges are rounded is not from 0 to 180 degrees.
    Smooth,
    /// The box whose steps tell corners has a side that is not above 0.
    Sides,
    /// The box whose steps tell corners does not hold them all.
    Outside,
}

impl fmt::Display for Unusable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nothing => f.write_str("no triangle of it has an area"),
            Self::TooMany => write!(f, "a mesh has at most {MOST} triangles and {MOST} corners"),
            Self::TooManyForCells => write!(
                f,
                "`kd`, `octree` and `grid` take at most {MOST_IN_CELLS} triangles that do not lie all over \
                 each other; `bvh` takes any"
            ),
            Self::Scale => f.write_str("`scale` is above 0 and at most 1e12"),
            Self::TooLarge => f.write_str("`at` and `turn` are numbers from -1e12 to 1e12"),
            Self::Smooth => f.write_str("`smooth` is an angle from 0 to 180 degrees"),
            Self::Sides => f.write_str("the sides of `Steps` are above 0"),
            Self::Outside => f.write_str("the box of `Steps` does not hold all corners"),
        }
    }
}

impl Ready {
    /// Makes a mesh of triangles: corners without normals smoothed up to an angle in degrees, told in a way,
    /// by default in steps of the box around them.
    ///
    /// # Errors
    /// Why they make no mesh.
    pub(super) fn new(
        triangles: Vec<[Corner; 3]>,
        degrees: Option<f64>,
        packing: Option<Packing>,
        accel: Accel,
    ) -> Result<Self, Unusable> {
        if degrees.is_some_and(|degrees| !(0.0..=180.0).contains(&degrees)) {
            return Err(Unusable::Smooth);
        }
        let mut model =
            Model { name: String::new(), parts: vec![Part { material: 0, triangles }], paints: vec![] };
        if let Some(degrees) = degrees {
            smooth(&mut model, degrees);
        }
        let packing = packing.unwrap_or_else(|| Packing::Packed(Steps::over(&model.bounds())));
        if let Packing::Packed(grid) = &packing {
            check(grid, &model)?;
        }
        let mut pieces = pieces(&model, &packing).0.into_iter();
        let piece = pieces.next().ok_or(Unusable::Nothing)?;
        if pieces.next().is_some() {
            return Err(Unusable::TooMany);
        }
        let around = |triangle: &[u16; 3]| Bounds::around(piece.corners(*triangle, &packing));
        let boxes: Vec<Bounds> = piece.triangles.iter().map(around).collect();
        let in_cells = !matches!(accel, Accel::Bvh | Accel::None);
        if in_cells && (boxes.len() > MOST_IN_CELLS || is_crowded(&boxes)) {
            return Err(Unusable::TooManyForCells);
        }
        let (built, bounds) = (accel.build(&boxes), Bounds::of(boxes));
        Ok(Self { piece, packing, built, bounds })
    }

    /// Makes the core's mesh, rounded to a number; its lists stay in memory as long as the program runs.
    pub(super) fn in_number<S: Rounded>(&'static self) -> scanray::Mesh<S> {
        mesh::assemble(&self.piece, &self.packing, &self.piece.triangles, self.built.leak(), &self.bounds)
    }
}

/// Demands that a box holds all corners, and that its steps tell them.
fn check(grid: &Steps, model: &Model) -> Result<(), Unusable> {
    if !grid.sides.iter().all(|side| *side > 0.0) {
        return Err(Unusable::Sides);
    }
    let corners = model.parts.iter().flat_map(|part| part.triangles.as_flattened());
    let is_told = |axis: usize, value: f64| {
        let step = (value - grid.low[axis]) / grid.sides[axis] * 65_536.0;
        (-0.5..65_535.5).contains(&step)
    };
    let mut values = corners.flat_map(|corner| corner.place.into_iter().enumerate());
    if values.all(|(axis, value)| is_told(axis, value)) { Ok(()) } else { Err(Unusable::Outside) }
}

/// Tells whether cells would name the things in boxes too often: 2^24 times together if there were 64 cells
/// along each side of the box around them.
fn is_crowded(boxes: &[Bounds]) -> bool {
    let whole = Bounds::of(boxes.iter().copied()).sides();
    let cells = |thing: &Bounds| {
        let along = thing
            .sides()
            .into_iter()
            .zip(whole)
            .map(|(side, whole)| if whole > 0.0 { 1.0 + 64.0 * side / whole } else { 1.0 });
        along.product::<f64>()
    };
    boxes.iter().map(cells).sum::<f64>() > f64::from(1 << 24)
}
