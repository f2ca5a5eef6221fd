//! Discrete walks: the cells of a grid from one to another, by whole numbers alone (row V3).
//!
//! | walk | neighbours share | cells from (0, 0, 0) to (x, y, z) | all cells that the line goes through |
//! |---|---|---|---|
//! | [`Bresenham`] | a face, an edge or a corner | `max(x, y, z) + 1` | no |
//! | [`Cohen`] | a face | `x + y + z + 1` | yes |
//! | [`Tripod`] | a face | `x + y + z + 1` | yes, and the line may begin and end anywhere in its cells |
//!
//! A ray that is sampled along Bresenham's walk passes between voxels without seeing them; one along the others
//! sees what a partition of the ray sees, in whole numbers. Where a line goes through an edge or a corner, the
//! cells that it only touches there are visited too, one of each pair.

mod bresenham;
mod cohen;
mod tripod;

pub use bresenham::Bresenham;
pub use cohen::Cohen;
pub use tripod::Tripod;

/// Is a cell, by its place along x, y and z.
pub type Cell = [i32; 3];

/// Is how far a walk goes along each axis, and where to.
#[derive(Clone, Copy, Debug)]
struct Way {
    /// Number of steps, of any units, at least 0.
    length: [i64; 3],
    rising: [bool; 3],
}

impl Way {
    fn between(from: [i64; 3], to: [i64; 3]) -> Self {
        let mut way = Self { length: [0; 3], rising: [true; 3] };
        let ends = from.into_iter().zip(to);
        for ((from, to), (length, rising)) in ends.zip(way.length.iter_mut().zip(&mut way.rising)) {
            (*length, *rising) = (to.saturating_sub(from).saturating_abs(), to >= from);
        }
        way
    }
}

/// Moves a cell's place along an axis by one.
fn step(place: &mut i32, rising: bool) {
    *place = if rising { place.saturating_add(1) } else { place.saturating_sub(1) };
}
