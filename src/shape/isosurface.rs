use super::cubic::Cubic;
use super::{Intersect, plane};
use crate::fault::Fault;
use crate::hit::{Crossing, Surface};
use crate::hull::Hull;
use crate::math::{Scalar, Wide};
use crate::ray::{Interval, Ray};
use crate::volume::{Course, Gradient, Grid, Piece, Place};

/// Is the surface in a sampled field: the points with `f(x, y, z) = a`, f mixed of the eight values around
/// (row O7). Inside is where f is not below a.
///
/// Along a ray f is a cubic polynomial in each cell. Where a ray has changed sides between entering and leaving a
/// cell its crossing is found, and so is the first of two or three in one cell, by where the polynomial turns; the
/// place is good to the last digit. Where the grid ends the surface is open: a ray that comes in where f is above a
/// is inside at once. The normal looks toward lower values.
///
/// Texture coordinates are those of a [`Plane`](super::Plane) of the normal's direction: two of the world's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isosurface<S: 'static = f32> {
    /// The field, of which any number of surfaces and volumes may share one.
    pub grid: &'static Grid<S>,
    /// The value a of the field on the surface, from 0 to 255.
    pub level: S,
    /// How normals are found.
    pub gradient: Gradient,
}

impl<S> Isosurface<S> {
    /// Makes the surface where a field has a value, with normals by central differences.
    pub const fn new(grid: &'static Grid<S>, level: S) -> Self {
        Self { grid, level, gradient: Gradient::Second }
    }

    /// Sets how normals are found.
    pub const fn with_gradient(mut self, gradient: Gradient) -> Self {
        self.gradient = gradient;
        self
    }
}

/// Is where a ray changes sides.
struct Change<S> {
    t: S,
    from_inside: bool,
}

impl<S: Scalar> Isosurface<S> {
    /// Tells whether the surface has an inside and an outside: no voxel of the grid's border lies in it.
    pub fn is_closed(&self) -> bool {
        let voxels = &self.grid.voxels;
        let sides = voxels.sides();
        let level = |voxel| S::from_i32(i32::from(voxels.value(voxel)));
        let outside = |voxel| level(voxel) < self.level;
        let [last_x, last_y, last_z] = sides.map(|side| side.saturating_sub(1));
        let across_z = |y: u16, x: u16| outside([x, y, 0]) && outside([x, y, last_z]);
        let across_y = |z: u16, x: u16| outside([x, 0, z]) && outside([x, last_y, z]);
        let across_x = |z: u16, y: u16| outside([0, y, z]) && outside([last_x, y, z]);
        let each = |outer: u16, inner: u16, holds: &dyn Fn(u16, u16) -> bool| {
            (0..=outer).all(|a| (0..=inner).all(|b| holds(a, b)))
        };
        each(last_y, last_x, &across_z) && each(last_z, last_x, &across_y) && each(last_z, last_y, &across_x)
    }

    /// Answers the side on which all values of a range lie; `None` if they lie on both.
    fn side(&self, [low, high]: [u8; 2]) -> Option<bool> {
        let number = |value: u8| S::from_i32(i32::from(value));
        if number(low) >= self.level {
            Some(true)
        } else if number(high) < self.level {
            Some(false)
        } else {
            None
        }
    }

    /// Answers how far the field is above the level at a place.
    #[inline(never)]
    fn above(&self, place: &Place<S>) -> S {
        self.grid.value(place) - self.level
    }

    /// Answers how far the field is above the level along a piece of a ray.
    ///
    /// The field is linear along each axis: with each axis at the place where the ray enters the cell or where it
    /// leaves, in all orders, its values are those that draw the cubic (its blossom; Ramshaw 1987). They lie
    /// between the values at the cell's corners, so that nothing is lost in any number.
    ///
    /// Called, not inlined: few cells have the surface in them, and the way to them takes no stack for it.
    #[inline(never)]
    fn along(&self, course: &Course<S>, piece: &Piece<S>) -> Cubic<S> {
        let ends = [piece.from, piece.to].map(|t| course.place(piece.cell, t).share);
        let [[x, y, z], [p, q, r]] = ends;
        let above = |share: [S; 3]| self.above(&Place { cell: piece.cell, share });
        let mean = |values: [S; 3]| {
            let [a, b, c] = values.map(|value| value.mul_wide(S::ONE));
            S::narrow((a + b + c).scale(1, 3))
        };
        Cubic([
            above([x, y, z]),
            mean([above([p, y, z]), above([x, q, z]), above([x, y, r])]),
            mean([above([p, q, z]), above([p, y, r]), above([x, q, r])]),
            above([p, q, r]),
        ])
    }

    /// Finds the first place inside the interval where a ray changes sides.
    fn change(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Change<S>> {
        let course = Course::of(self.grid, ray, interval)?;
        let mut before = None;
        for piece in course.pieces(self.grid, ray) {
            let known = self.grid.voxels.of_block(piece.cell).and_then(|range| self.side(range));
            let known = known.or_else(|| self.side(self.grid.voxels.of_cell(piece.cell)));
            let cubic = if known.is_none() { Some(self.along(&course, &piece)) } else { None };
            let first = cubic.map_or(known, |cubic| Some(cubic.0[0] >= S::ZERO))?;
            // Between two cells only rounding can do that, on a surface that lies where they meet.
            if let Some(from_inside) = before.filter(|before| *before != first) {
                return Some(Change { t: piece.from, from_inside });
            }
            if let Some(share) = cubic.and_then(|cubic| cubic.first_change(first)) {
                let t = piece.from.add_product(piece.to - piece.from, share);
                return Some(Change { t, from_inside: first });
            }
            before = Some(first);
        }
        None
    }
}

impl<S: Scalar> Intersect<S> for Isosurface<S> {
    #[inline(never)]
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let Change { t, from_inside } = self.change(ray, interval)?;
        // The side the ray comes from is kept in place of a coordinate.
        let u = if from_inside { S::ONE } else { S::ZERO };
        interval.contains(t).then_some(Crossing { u, ..Crossing::at(t) })
    }

    #[inline(never)]
    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        let point = ray.at(crossing.t);
        let place = self.grid.place(point);
        let normal = self.gradient.normal(self.grid, &place).unwrap_or(-ray.direction);
        // Near the outline a mixed normal may look away from a viewer who sees the surface.
        let away = (normal.dot(ray.direction) > S::ZERO) != (crossing.u > S::ZERO);
        let normal = if away { normal.reflect(ray.direction) } else { normal };
        let (u, v) = plane::flatten(point, normal);
        // Cells count as parts: their light differs.
        let [i, j, k] = place.cell;
        let part = i ^ j.rotate_left(5) ^ k.rotate_left(10);
        Surface { point, normal, u, v, part }
    }

    #[inline(never)]
    fn hull(&self) -> Hull<S> {
        Hull::Box(self.grid.bounds())
    }

    #[inline(never)]
    fn check(&self) -> Result<(), Fault> {
        self.grid.check()?;
        let highest = S::from_i32(255);
        if self.level >= S::ZERO && self.level <= highest { Ok(()) } else { Err(Fault::OutOfRange) }
    }
}
