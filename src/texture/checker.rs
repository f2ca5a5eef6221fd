use crate::color::Rgb;
use crate::math::Scalar;

/// Is a chessboard: tile (i, j) = floor((u, v) per_unit) is even where i + j is (row T5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checker<S = f32> {
    /// Colour of the tile between the origin and (1, 1) tiles.
    pub even: Rgb<S>,
    /// Colour of its neighbours.
    pub odd: Rgb<S>,
    /// Tiles to a unit of the shape's texture coordinates.
    pub per_unit: S,
}

impl<S> Checker<S> {
    /// Makes a chessboard with so many tiles to a unit of the texture coordinates.
    pub const fn new(even: Rgb<S>, odd: Rgb<S>, per_unit: S) -> Self {
        Self { even, odd, per_unit }
    }
}

impl<S: Scalar> Checker<S> {
    /// Answers the colour of the tile at texture coordinates.
    pub fn color(&self, u: S, v: S) -> Rgb<S> {
        let tile = S::floor(u.mul_wide(self.per_unit)) ^ S::floor(v.mul_wide(self.per_unit));
        if tile & 1 == 0 { self.even } else { self.odd }
    }

    /// Answers a number of the tile at texture coordinates, other for each of 2^16 by 2^16 neighbours.
    pub fn tile(&self, u: S, v: S) -> u32 {
        let [i, j] = [u, v].map(|along| S::floor(along.mul_wide(self.per_unit)) as u32);
        i ^ j.rotate_left(16)
    }

    /// Tells whether every value is one a scene may contain.
    pub fn in_range(&self) -> bool {
        self.even.in_range() && self.odd.in_range() && self.per_unit.in_range()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_differ_and_diagonals_agree_on_both_sides_of_zero() {
        let board = Checker::new(Rgb::WHITE, Rgb::BLACK, 2.0_f32);
        for i in -4..4 {
            for j in -4..4 {
                let color = board.color(0.25 + 0.5 * i as f32, 0.25 + 0.5 * j as f32);
                assert_eq!(color == Rgb::WHITE, (i + j) % 2 == 0, "tile {i}, {j}");
            }
        }
    }
}
