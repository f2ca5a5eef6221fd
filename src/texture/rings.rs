use crate::color::Rgb;
use crate::math::Scalar;

/// Is rings around a point: ring n = floor(|(u, v) - center| per_unit) is even where n is (row T5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rings<S = f32> {
    /// Colour of the disc in the middle.
    pub even: Rgb<S>,
    /// Colour of the ring around it.
    pub odd: Rgb<S>,
    /// Texture coordinates of the middle.
    pub center: [S; 2],
    /// Rings to a unit of the texture coordinates.
    pub per_unit: S,
}

impl<S> Rings<S> {
    /// Makes rings around a point, so many to a unit of the texture coordinates.
    pub const fn new(even: Rgb<S>, odd: Rgb<S>, center: [S; 2], per_unit: S) -> Self {
        Self { even, odd, center, per_unit }
    }
}

impl<S: Scalar> Rings<S> {
    /// Answers the colour of the ring at texture coordinates.
    pub fn color(&self, u: S, v: S) -> Rgb<S> {
        if self.tile(u, v) & 1 == 0 { self.even } else { self.odd }
    }

    /// Answers the number of the ring at texture coordinates.
    pub fn tile(&self, u: S, v: S) -> u32 {
        let (u, v) = (u - self.center[0], v - self.center[1]);
        let distance = S::sqrt(u.mul_wide(u) + v.mul_wide(v));
        S::floor(distance.mul_wide(self.per_unit)) as u32
    }

    /// Tells whether every value is one a scene may contain.
    pub fn in_range(&self) -> bool {
        let [u, v] = self.center;
        let colors = self.even.in_range() && self.odd.in_range();
        colors && [u, v, self.per_unit].iter().all(|value| value.in_range())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_depend_on_the_distance_from_their_middle_alone() {
        let target = Rings::new(Rgb::WHITE, Rgb::BLACK, [0.5_f32, -1.0], 2.0);
        // 3, 4 and 5 in every order are 5 away, the eleventh half.
        for (u, v) in [(5.0, 0.0), (0.0, -5.0), (3.0, 4.0), (-4.0, 3.0)] {
            assert_eq!(target.tile(0.5 + 1.01 * u, -1.0 + 1.01 * v), 10);
            assert_eq!(target.color(0.5 + 1.01 * u, -1.0 + 1.01 * v), Rgb::WHITE);
            assert_eq!(target.color(0.5 + 0.99 * u, -1.0 + 0.99 * v), Rgb::BLACK);
        }
        assert_eq!(target.color(0.5, -1.0), Rgb::WHITE);
    }
}
