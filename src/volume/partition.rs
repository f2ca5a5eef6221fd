use super::Grid;
use super::grid::{Place, lowest, share_of};
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};

/// Is the way of a ray through a grid, counted in voxels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Course<S> {
    /// Distances at which the ray comes in and at which it goes out.
    enter: S,
    leave: S,
    /// Where it comes in, and how far it gets along each axis to a unit of distance.
    start: [S; 3],
    rate: [S; 3],
}

/// Is the piece of a ray in one cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece<S> {
    /// The cell, named by its lowest voxel.
    pub cell: [u16; 3],
    /// Distances at which the ray enters and leaves it.
    pub from: S,
    pub to: S,
}

/// Cuts a ray at the planes between cells (row V2): each step goes to the nearest of the planes ahead,
/// `t = min(tx, ty, tz)`, and the one passed is followed by the next, `t_w += dt_w` (Amanatides and Woo 1987).
#[derive(Clone, Debug)]
pub(crate) struct Partition<S> {
    axes: [Axis<S>; 3],
    at: S,
    leave: S,
}

/// Is the planes across one axis.
#[derive(Clone, Copy, Debug)]
struct Axis<S> {
    cell: u16,
    /// The last cell on the way, and whether the next one is higher.
    last: u16,
    rising: bool,
    /// Distance of the next plane, and from one to another.
    next: S,
    step: S,
}

impl<S: Scalar> Piece<S> {
    /// Divides the piece into so many equal ones.
    pub fn divided(self, count: u8) -> impl Iterator<Item = Self> {
        let step = (self.to - self.from).ratio(S::from_i32(i32::from(count)));
        let end = move |n: u8| self.from.add_product(step, S::from_i32(i32::from(n)));
        (1..=count).map(move |n| Self {
            from: end(n - 1),
            to: if n == count { self.to } else { end(n) },
            ..self
        })
    }
}

impl<S: Scalar> Course<S> {
    /// Finds where a ray is in a grid and in an interval; `None` where it is not.
    pub fn of(grid: &Grid<S>, ray: &Ray<S>, interval: &Interval<S>) -> Option<Self> {
        let (mut enter, mut leave) = (interval.near, interval.far);
        let (low, high, Ray { origin, direction }) = (grid.low, grid.high(), *ray);
        let slabs = [
            [low.x, high.x, origin.x, direction.x],
            [low.y, high.y, origin.y, direction.y],
            [low.z, high.z, origin.z, direction.z],
        ];
        // Arrays zipped by value would lie on the stack twice.
        for &[low, high, o, d] in &slabs {
            if d == S::ZERO {
                if o < low || o > high {
                    return None;
                }
                continue;
            }
            let (to_low, to_high) = ((low - o).ratio(d), (high - o).ratio(d));
            enter = enter.max(to_low.min(to_high));
            leave = leave.min(to_low.max(to_high));
        }
        // What is no number is nowhere.
        let meets = enter < leave;
        if !meets {
            return None;
        }
        let spacing = grid.spacing.to_array();
        let counted = |v: Vec3<S>| {
            let [x, y, z] = v.to_array();
            [x.ratio(spacing[0]), y.ratio(spacing[1]), z.ratio(spacing[2])]
        };
        let (start, rate) = (counted(ray.at(enter) - grid.low), counted(ray.direction));
        Some(Self { enter, leave, start, rate })
    }

    /// Answers where in a cell the ray is at a distance.
    pub fn place(&self, cell: [u16; 3], t: S) -> Place<S> {
        let mut share = [S::ZERO; 3];
        let ways = self.start.into_iter().zip(self.rate).zip(cell);
        for (share, ((start, rate), cell)) in share.iter_mut().zip(ways) {
            *share = share_of(start.add_product(rate, t - self.enter), cell);
        }
        Place { cell, share }
    }

    /// Cuts the way into the pieces that lie in one cell each, from first to last.
    pub fn pieces(&self, grid: &Grid<S>, ray: &Ray<S>) -> Partition<S> {
        let [x, y, z] = grid.voxels.sides();
        let (spacing, direction) = (grid.spacing, ray.direction);
        let axes = [
            self.axis(self.start[0], direction.x, spacing.x, x),
            self.axis(self.start[1], direction.y, spacing.y, y),
            self.axis(self.start[2], direction.z, spacing.z, z),
        ];
        Partition { axes, at: self.enter, leave: self.leave }
    }

    fn axis(&self, start: S, direction: S, spacing: S, side: u16) -> Axis<S> {
        let (cell, rising) = (lowest(start, side), direction >= S::ZERO);
        let last = if rising { side.saturating_sub(2) } else { 0 };
        if direction == S::ZERO {
            return Axis { cell, last, rising, next: S::FAR, step: S::FAR };
        }
        let share = share_of(start, cell);
        let step = spacing.ratio(direction.abs());
        let ahead = if rising { S::ONE - share } else { share };
        Axis { cell, last, rising, next: self.enter.add_product(step, ahead), step }
    }
}

impl<S: Scalar> Axis<S> {
    /// Goes on to the next cell; `false` at the border.
    fn pass(&mut self) -> bool {
        if self.cell == self.last {
            return false;
        }
        self.cell = if self.rising { self.cell.saturating_add(1) } else { self.cell.saturating_sub(1) };
        self.next = self.next + self.step;
        true
    }
}

impl<S: Scalar> Iterator for Partition<S> {
    type Item = Piece<S>;

    fn next(&mut self) -> Option<Piece<S>> {
        // A way to what is no number would never end.
        let goes_on = self.at < self.leave;
        if !goes_on {
            return None;
        }
        let cell = self.axes.map(|axis| axis.cell);
        let [x, y, z] = &mut self.axes;
        let nearest = if x.next < y.next && x.next < z.next {
            x
        } else if y.next < z.next {
            y
        } else {
            z
        };
        // A plane that rounding has put before the last one is passed there.
        let (from, to) = (self.at, nearest.next.min(self.leave).max(self.at));
        self.at = if nearest.next < self.leave && nearest.pass() { to } else { self.leave };
        Some(Piece { cell, from, to })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fixed;
    use crate::volume::Voxels;

    static VALUES: [u8; 6 * 5 * 4] = [0; 6 * 5 * 4];

    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64, precision: f64) {
        let v = |[x, y, z]: [f64; 3]| Vec3::new(make(x), make(y), make(z));
        let grid = Grid::new(Voxels::new([6, 5, 4], &VALUES), v([-1.0, -2.0, 0.5]), v([0.5, 1.0, 0.25]));
        // Slanted, along the axes both ways, through edges, and from inside.
        let ways = [
            ([-3.0, -4.0, -1.0], [1.0, 1.3, 0.7]),
            ([3.0, 3.0, 3.0], [-1.0, -1.1, -0.8]),
            ([-2.0, 0.5, 0.8], [1.0, 0.0, 0.0]),
            ([0.2, 5.0, 0.8], [0.0, -1.0, 0.0]),
            ([-1.5, -3.0, 0.6], [0.5, 1.0, 0.0]),
            ([0.1, 0.2, 0.9], [0.3, -0.4, 0.2]),
        ];
        for (origin, toward) in ways {
            let ray = Ray::new(v(origin), v(toward).normalize().expect("a direction").0);
            let course = Course::of(&grid, &ray, &Interval::AHEAD).expect("it meets the grid");
            let pieces: [Option<Piece<S>>; 14] = {
                let mut partition = course.pieces(&grid, &ray);
                core::array::from_fn(|_| partition.next())
            };
            assert!(pieces[13].is_none(), "no more than 5 + 4 + 3 planes and the border");
            let mut reached = course.enter;
            for piece in pieces.into_iter().flatten() {
                assert_eq!(piece.from, reached, "no gap");
                reached = piece.to;
                let middle = read(piece.from) / 2.0 + read(piece.to) / 2.0;
                let point = ray.at(make(middle)) - grid.low;
                let counted = [read(point.x) / 0.5, read(point.y), read(point.z) / 0.25];
                for (counted, cell) in counted.into_iter().zip(piece.cell) {
                    let share = counted - f64::from(cell);
                    assert!((-precision..=1.0 + precision).contains(&share), "{piece:?}: {counted}");
                }
            }
            assert!((read(reached) - read(course.leave)).abs() < precision, "to the end");
        }
        let past = Ray::new(v([-3.0, 9.0, 1.0]), v([1.0, 0.0, 0.0]));
        assert!(Course::of(&grid, &past, &Interval::AHEAD).is_none());
    }

    #[test]
    fn pieces_lie_in_their_cells_and_leave_no_gap() {
        check(|x| x as f32, f64::from, 1e-5);
        check(Fixed::new, Fixed::to_f64, 1e-4);
        check(|x| x, |x| x, 1e-12);
    }

    #[test]
    fn equal_parts_fill_a_piece() {
        let piece = Piece { cell: [0; 3], from: 2.0_f64, to: 3.5 };
        let mut parts = piece.divided(3);
        let ends: [Option<[f64; 2]>; 4] =
            core::array::from_fn(|_| parts.next().map(|part| [part.from, part.to]));
        assert_eq!(ends, [Some([2.0, 2.5]), Some([2.5, 3.0]), Some([3.0, 3.5]), None]);
    }

    #[test]
    fn ways_that_are_no_numbers_end() {
        let grid = Grid::new(Voxels::new([6, 5, 4], &VALUES), Vec3::ZERO, Vec3::new(0.5, 1.0, 0.25));
        for (at, to) in [(f32::NAN, 1.0), (1.0, f32::NAN), (f32::INFINITY, f32::NAN), (1e38, 1e-38)] {
            let ray = Ray::new(Vec3::new(at, 1.0, 0.5), Vec3::new(to, 0.1, 0.1));
            for far in [1e18, f32::INFINITY, f32::NAN] {
                let course = Course::of(&grid, &ray, &Interval::new(0.0, far));
                assert!(course.is_none_or(|course| course.pieces(&grid, &ray).take(100).count() < 100));
            }
            let lost = Course { enter: at, leave: to, start: [at; 3], rate: [to; 3] };
            assert!(lost.pieces(&grid, &ray).take(100).count() < 100, "{lost:?}");
        }
    }
}
