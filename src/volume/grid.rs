use super::Voxels;
use crate::aabb::Aabb;
use crate::fault::Fault;
use crate::math::{Scalar, Vec3};

/// Is a Cartesian grid of voxels in world space: voxel (i, j, k) stands at `low + (i, j, k) spacing`.
///
/// Between eight neighbouring voxels lies a cell; a grid of n voxels along an axis has n - 1 cells there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid<S = f32> {
    /// The values.
    pub voxels: Voxels,
    /// Where voxel (0, 0, 0) stands.
    pub low: Vec3<S>,
    /// Distance from voxel to voxel along each axis, at least 1/1024.
    pub spacing: Vec3<S>,
}

impl<S> Grid<S> {
    /// Makes a grid of its values, the place of the first and the distances from one to the next.
    pub const fn new(voxels: Voxels, low: Vec3<S>, spacing: Vec3<S>) -> Self {
        Self { voxels, low, spacing }
    }
}

/// Is a place in a cell of a grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<S> {
    /// The cell, named by its lowest voxel.
    pub cell: [u16; 3],
    /// Shares of the way across the cell, from 0 to 1.
    pub share: [S; 3],
}

impl<S: Scalar> Grid<S> {
    /// Answers where the last voxel stands.
    pub fn high(&self) -> Vec3<S> {
        let [x, y, z] = self.voxels.sides().map(|side| S::from_i32(i32::from(side.saturating_sub(1))));
        let Vec3 { x: a, y: b, z: c } = self.spacing;
        self.low + Vec3::new(a * x, b * y, c * z)
    }

    /// Answers the box between the first and the last voxel.
    pub fn bounds(&self) -> Aabb<S> {
        Aabb::between(self.low, self.high())
    }

    /// Finds the place of a point; of one outside the grid the nearest.
    pub fn place(&self, point: Vec3<S>) -> Place<S> {
        let (off, spacing) = ((point - self.low).to_array(), self.spacing.to_array());
        let mut place = Place { cell: [0; 3], share: [S::ZERO; 3] };
        let axes = off.into_iter().zip(spacing).zip(self.voxels.sides());
        let parts = place.cell.iter_mut().zip(&mut place.share);
        for (((off, spacing), side), (cell, share)) in axes.zip(parts) {
            let along = off.ratio(spacing);
            *cell = lowest(along, side);
            *share = share_of(along, *cell);
        }
        place
    }

    /// Answers the field at a place: the eight values around, mixed by its shares (row V4):
    /// `sum of v_ijk w_i(x) w_j(y) w_k(z)`, where `w_0(s) = 1 - s` and `w_1(s) = s`; 0 to 255.
    pub fn value(&self, place: &Place<S>) -> S {
        let values = |voxel| S::from_i32(i32::from(self.voxels.value(voxel)));
        place.mix(values)
    }

    /// Tells what is wrong with the grid, if anything.
    ///
    /// # Errors
    /// A number of values that is not that of the voxels, voxels too close together, a corner out of range.
    pub fn check(&self) -> Result<(), Fault> {
        let closest = S::from_i32(1024).recip();
        if !self.voxels.fits() {
            Err(Fault::Voxels)
        } else if !(self.low.in_range() && self.high().in_range()) {
            Err(Fault::OutOfRange)
        } else if self.spacing.to_array().iter().all(|spacing| *spacing >= closest && spacing.in_range()) {
            Ok(())
        } else {
            Err(Fault::Spacing)
        }
    }
}

/// Answers the cell that holds a coordinate counted in voxels, of an axis of so many voxels.
pub(super) fn lowest<S: Scalar>(along: S, side: u16) -> u16 {
    let cell = S::floor(along.mul_wide(S::ONE)).max(0);
    u16::try_from(cell).unwrap_or(u16::MAX).min(side.saturating_sub(2))
}

/// Answers how far along a cell a coordinate lies that is counted in voxels, from 0 to 1.
pub(super) fn share_of<S: Scalar>(along: S, cell: u16) -> S {
    (along - S::from_i32(i32::from(cell))).max(S::ZERO).min(S::ONE)
}

impl<S: Scalar> Place<S> {
    /// Mixes what is read at the eight voxels around.
    #[inline]
    pub(super) fn mix(&self, read: impl Fn([u16; 3]) -> S) -> S {
        let ([x, y, z], [right, up, back]) = (self.cell, self.share);
        let between = |a: S, b: S, share: S| a.add_product(b - a, share);
        let line = |y: u16, z: u16| between(read([x, y, z]), read([x.saturating_add(1), y, z]), right);
        let face = |z: u16| between(line(y, z), line(y.saturating_add(1), z), up);
        between(face(z), face(z.saturating_add(1)), back)
    }

    /// Answers the voxel nearest to the place, as a place of its own (row V4).
    pub fn nearest(self) -> Self {
        let Self { cell, share } = self;
        Self { cell, share: share.map(|share| if share < S::HALF { S::ZERO } else { S::ONE }) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fixed;

    /// Is `3 i + 50 j + 100 k` at voxel (i, j, k).
    static RAMP: [u8; 12] = [0, 3, 6, 50, 53, 56, 100, 103, 106, 150, 153, 156];

    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let v = |x, y, z| Vec3::new(make(x), make(y), make(z));
        let grid = Grid::new(Voxels::new([3, 2, 2], &RAMP), v(-1.0, 2.0, 3.0), v(0.5, 2.0, 0.25));
        assert_eq!((grid.check(), grid.high()), (Ok(()), v(0.0, 4.0, 3.25)));
        let value = |x, y, z| read(grid.value(&grid.place(v(x, y, z))));
        // A field that is linear along each axis is met exactly.
        let places = [(-1.0, 2.0, 3.0), (-0.6, 2.3, 3.2), (-0.4, 3.9, 3.01), (0.0, 4.0, 3.25)];
        for (x, y, z) in places {
            let exact = 3.0 * (x + 1.0) / 0.5 + 50.0 * (y - 2.0) / 2.0 + 100.0 * (z - 3.0) / 0.25;
            assert!((value(x, y, z) - exact).abs() < 2e-3, "{} instead of {exact}", value(x, y, z));
        }
        assert_eq!(value(-9.0, 99.0, 3.0), 50.0, "outside as on the border");
        let nearest = grid.place(v(-0.7, 3.1, 3.1)).nearest();
        assert_eq!(read(grid.value(&nearest)), 53.0);
    }

    #[test]
    fn a_place_between_voxels_has_their_values_mixed_and_the_nearest_has_one() {
        check(|x| x as f32, f64::from);
        check(Fixed::new, Fixed::to_f64);
        check(|x| x, |x| x);
    }

    #[test]
    fn what_is_wrong_with_a_grid_is_named() {
        let grid =
            |spacing: f32| Grid::new(Voxels::new([3, 2, 2], &RAMP), Vec3::ZERO, Vec3::new(1.0, spacing, 1.0));
        assert_eq!(grid(0.0).check(), Err(Fault::Spacing));
        assert_eq!(grid(-1.0).check(), Err(Fault::Spacing));
        assert_eq!(grid(f32::NAN).check(), Err(Fault::OutOfRange));
        let short = Grid::<f32> { voxels: Voxels::new([3, 2, 3], &RAMP), ..grid(1.0) };
        assert_eq!(short.check(), Err(Fault::Voxels));
        let low = Vec3::from_f64(1000.0, 0.0, 0.0);
        let far = Grid::<Fixed>::new(Voxels::new([3, 2, 2], &RAMP), low, Vec3::from_f64(20.0, 1.0, 1.0));
        assert_eq!(far.check(), Err(Fault::OutOfRange));
    }
}
