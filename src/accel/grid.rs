use super::lattice::{Lattice, Passage, Steps};
use super::lists::Lists;
use super::{Hierarchy, Visit};
use crate::fault::Fault;
use crate::math::Scalar;
use crate::ray::{Interval, Ray};

/// Is a box of equal cubes (A. Fujimoto et al. 1986; the walk of J. Amanatides and A. Woo 1987, "A Fast Voxel
/// Traversal Algorithm for Ray Tracing").
///
/// Of the walk's three distances only the one that the ray has passed is moved on, as there; but each is
/// taken from its plane, not from the last one, so that no rounding adds up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid<S: 'static = f32> {
    /// The cube that the grid is told in.
    pub lattice: Lattice<S>,
    /// The grid's lowest corner, in steps of the lattice.
    pub low: [u16; 3],
    /// How many steps a cell is wide; the last cell of an axis may be cut off by the cube's end.
    pub size: u16,
    /// How many cells lie along x, y and z.
    pub cells: [u16; 3],
    /// The number of each cell's list, x by x, row by row along y, layer by layer along z.
    pub content: &'static [u16],
    /// How many things the lists name together.
    pub count: u16,
    /// What cells hold.
    pub lists: Lists,
}

/// Is a ray's way through the cells along one axis.
#[derive(Clone, Copy, Debug)]
struct Track<S> {
    /// Distance at which the ray leaves the cell along this axis.
    exit: S,
    /// The step at which it does.
    face: u16,
    /// How many cells lie ahead.
    ahead: u16,
    /// How many places in the list of cells the next one is farther on, wrapping where it is back.
    stride: u32,
}

impl<S: Scalar> Grid<S> {
    /// Answers the step at which a cell of an axis begins, and after the last one that at which they end.
    fn face(&self, axis: usize, cell: u16) -> u16 {
        let low = self.low.get(axis).copied().unwrap_or(0);
        low.saturating_add(self.size.saturating_mul(cell))
    }

    fn bounds(&self) -> Steps {
        let high = [0, 1, 2].map(|axis| self.face(axis, self.cells.get(axis).copied().unwrap_or(0)));
        [self.low, high]
    }

    /// Answers how many places apart in the list the neighbours along each axis are.
    fn strides(&self) -> [u32; 3] {
        let [x, y, _] = self.cells.map(u32::from);
        [1, x, x.wrapping_mul(y)]
    }

    /// Answers the place of the cell in which a ray is at a distance, and its way on from there.
    fn begin(&self, passage: &Passage<S>, near: S) -> (u32, [Track<S>; 3]) {
        let mut place = 0_u32;
        let strides = self.strides();
        let mut tracks = [Track { exit: S::FAR, face: 0, ahead: 0, stride: 0 }; 3];
        let axes = tracks.iter_mut().zip(strides).zip(self.low.into_iter().zip(self.cells));
        for (axis, ((track, stride), (low, cells))) in axes.enumerate() {
            let last = cells.saturating_sub(1);
            let steps = passage.step_at(axis, near).saturating_sub(low);
            let cell = steps.checked_div(self.size).unwrap_or(0).min(last);
            place = place.wrapping_add(stride.wrapping_mul(u32::from(cell)));
            *track = if passage.descends(axis) {
                let face = self.face(axis, cell);
                Track { exit: passage.reach(axis, face), face, ahead: cell, stride: stride.wrapping_neg() }
            } else {
                let face = self.face(axis, cell.saturating_add(1));
                Track { exit: passage.reach(axis, face), face, ahead: last.saturating_sub(cell), stride }
            };
        }
        (place, tracks)
    }
}

impl<S: Scalar> Hierarchy<S> for Grid<S> {
    fn walk(&self, ray: &Ray<S>, interval: &Interval<S>, visit: Visit<'_, S>) {
        let Some(entry) = self.lattice.enter(ray, interval) else { return };
        let mut passage = Passage::new(entry);
        let Some((near, _)) = passage.span(&self.bounds()) else { return };
        let (mut place, mut tracks) = self.begin(&passage, near);
        while let Some(list) = self.content.get(place as usize) {
            if !self.lists.visit(*list, &mut passage, interval.near, visit) {
                return;
            }
            let [x, y, z] = tracks.map(|track| track.exit);
            let axis = if x < y { usize::from(z < x) << 1 } else { 1 + usize::from(z < y) };
            let Some(track) = tracks.get_mut(axis) else { return };
            if track.ahead == 0 || track.exit > passage.far() {
                return;
            }
            track.ahead -= 1;
            track.face = if passage.descends(axis) {
                track.face.saturating_sub(self.size)
            } else {
                track.face.saturating_add(self.size)
            };
            track.exit = passage.reach(axis, track.face);
            place = place.wrapping_add(track.stride);
        }
    }

    fn count(&self) -> u16 {
        self.count
    }

    fn check(&self) -> Result<(), Fault> {
        let cells = self.cells.iter().fold(1_u64, |product, cells| product * u64::from(*cells));
        // The last cell of each axis has to begin in the cube.
        let begins = |(low, cells): (u16, u16)| {
            u32::from(low) + u32::from(self.size) * u32::from(cells.max(1) - 1) <= u32::from(u16::MAX)
        };
        let placed = self.size > 0 && self.low.into_iter().zip(self.cells).all(begins);
        let listed =
            cells == self.content.len() as u64 && self.content.iter().all(|list| self.lists.has(*list));
        if placed && listed && self.lattice.is_in_range() && self.lists.are_sound(self.count) {
            Ok(())
        } else {
            Err(Fault::Hierarchy)
        }
    }
}
