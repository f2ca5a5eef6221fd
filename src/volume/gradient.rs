use super::Grid;
use super::grid::Place;
use crate::math::{Scalar, Vec3};

/// Names how the gradient of a sampled field is estimated: by differences of which order (row V5).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Gradient {
    /// By the differences of neighbouring voxels, `(f_i+1 - f_i) / dx`: the gradient of the field between them
    /// itself, right to the first order. It jumps from cell to cell, so that light shows the cells.
    First,
    /// By central differences, `(f_i+1 - f_i-1) / 2 dx`, at the eight voxels around, mixed as the values are: right
    /// to the second order, and without jumps. On the grid's border, which has no neighbour, of the first order.
    #[default]
    Second,
}

impl Gradient {
    /// Answers by how many levels the field grows to a voxel along each axis at a place.
    pub fn differences<S: Scalar>(self, grid: &Grid<S>, place: &Place<S>) -> [S; 3] {
        match self {
            Self::First => [0, 1, 2].map(|axis| place.mix(|voxel| forward(grid, place.cell, voxel, axis))),
            Self::Second => [0, 1, 2].map(|axis| place.mix(|voxel| central(grid, voxel, axis))),
        }
    }

    /// Answers the unit normal of the field's level surface at a place, toward lower values; `None` where the field
    /// is level.
    #[inline(never)]
    pub fn normal<S: Scalar>(self, grid: &Grid<S>, place: &Place<S>) -> Option<Vec3<S>> {
        let [x, y, z] = self.differences(grid, place);
        // In the measure of the narrowest spacing: by world units a difference could leave the range.
        let Vec3 { x: a, y: b, z: c } = grid.spacing;
        let narrowest = a.min(b).min(c);
        let slope = |difference: S, spacing: S| -(difference * narrowest.ratio(spacing));
        Vec3::new(slope(x, a), slope(y, b), slope(z, c)).normalize().map(|(normal, _)| normal)
    }
}

/// Answers a voxel with another coordinate along an axis.
fn moved(voxel: [u16; 3], axis: usize, to: u16) -> [u16; 3] {
    let [x, y, z] = voxel;
    match axis {
        0 => [to, y, z],
        1 => [x, to, z],
        _ => [x, y, to],
    }
}

/// Answers a voxel's coordinate along an axis.
fn along([x, y, z]: [u16; 3], axis: usize) -> u16 {
    match axis {
        0 => x,
        1 => y,
        _ => z,
    }
}

fn difference<S: Scalar>(grid: &Grid<S>, low: [u16; 3], high: [u16; 3]) -> S {
    S::from_i32(i32::from(grid.voxels.value(high)) - i32::from(grid.voxels.value(low)))
}

/// Answers the difference across a cell at one of its edges along an axis: that on which a voxel lies.
fn forward<S: Scalar>(grid: &Grid<S>, cell: [u16; 3], voxel: [u16; 3], axis: usize) -> S {
    let low = along(cell, axis);
    difference(grid, moved(voxel, axis, low), moved(voxel, axis, low.saturating_add(1)))
}

/// Answers the central difference at a voxel, to one voxel along an axis.
fn central<S: Scalar>(grid: &Grid<S>, voxel: [u16; 3], axis: usize) -> S {
    let (at, side) = (along(voxel, axis), along(grid.voxels.sides(), axis));
    let (low, high) = (at.saturating_sub(1), at.saturating_add(1).min(side.saturating_sub(1)));
    let difference = difference(grid, moved(voxel, axis, low), moved(voxel, axis, high));
    if high.saturating_sub(low) == 2 { difference * S::HALF } else { difference }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fixed;
    use crate::volume::Voxels;

    /// Answers `f` at each of 4 x 4 x 4 voxels.
    const fn field(x2: u8, x: u8, y: u8, z: u8) -> [u8; 64] {
        let mut values = [0; 64];
        let mut i = 0;
        while i < 64 {
            let (a, b, c) = (i % 4, i / 4 % 4, i / 16);
            values[i as usize] = x2 * a * a + x * a + y * b + z * c;
            i += 1;
        }
        values
    }

    static LINEAR: [u8; 64] = field(0, 20, 7, 30);
    static SQUARE: [u8; 64] = field(10, 0, 0, 0);

    fn places<S: Scalar>(make: fn(f64) -> S) -> impl Iterator<Item = Place<S>> {
        let shares = [0.0, 0.25, 0.7, 1.0];
        let share = move |i: usize| make(shares[i % 4]);
        (0..27).map(move |i| Place {
            cell: [i % 3, i / 3 % 3, i / 9].map(|c| c as u16),
            share: [share(i), share(i + 1), share(i / 2)],
        })
    }

    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let spacing = Vec3::new(make(0.5), make(1.0), make(0.25));
        let grid = |values| Grid::new(Voxels::new([4; 3], values), Vec3::ZERO, spacing);
        let (linear, square) = (grid(&LINEAR), grid(&SQUARE));
        let exact = Vec3::new(make(-40.0), make(-7.0), make(-120.0)).normalize().expect("a slope").0;
        for place in places(make) {
            for order in [Gradient::First, Gradient::Second] {
                let off = order.differences(&linear, &place).map(read);
                assert!(
                    off.iter().zip([20.0, 7.0, 30.0]).all(|(a, b)| (a - b).abs() < 1e-5),
                    "{order:?}: {off:?}"
                );
                let normal = order.normal(&linear, &place).expect("a slope");
                assert!(read((normal - exact).length()) < 1e-5, "{order:?}: {normal:?}");
            }
        }
        // Of 10 x^2 central differences are exact at a voxel, forward ones in the middle of a cell.
        let at = |cell, share| Place { cell: [cell, 1, 1], share: [make(share); 3] };
        let along = |order: Gradient, place| read(order.differences(&square, &place)[0]);
        assert_eq!([0.0, 0.5].map(|share| along(Gradient::First, at(1, share))), [30.0, 30.0]);
        assert_eq!([0.0, 0.5].map(|share| along(Gradient::Second, at(1, share))), [20.0, 30.0]);
        assert_eq!(along(Gradient::Second, at(0, 0.0)), 10.0, "one-sided on the border");
    }

    #[test]
    fn differences_of_both_orders_are_exact_on_a_ramp_and_apart_on_a_parabola() {
        check(|x| x as f32, f64::from);
        check(Fixed::new, Fixed::to_f64);
        check(|x| x, |x| x);
    }

    #[test]
    fn a_level_field_has_no_normal() {
        static LEVEL: [u8; 8] = [77; 8];
        let grid = Grid::new(Voxels::new([2; 3], &LEVEL), Vec3::ZERO, Vec3::new(1.0_f32, 1.0, 1.0));
        let place = grid.place(Vec3::new(0.3, 0.6, 0.1));
        assert_eq!(
            [Gradient::First, Gradient::Second].map(|order| order.normal(&grid, &place)),
            [None, None]
        );
    }
}
