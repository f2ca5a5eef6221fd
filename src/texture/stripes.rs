use crate::color::Rgb;
use crate::math::Scalar;

/// Is stripes: stripe n = floor(u a + v b) is even where n is (row T5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stripes<S = f32> {
    /// Colour of the stripe that begins at the origin.
    pub even: Rgb<S>,
    /// Colour of its neighbours.
    pub odd: Rgb<S>,
    /// Stripes to a unit of u and to a unit of v: (a, 0) are upright ones, (a, a) slanting ones.
    pub per_unit: [S; 2],
}

impl<S> Stripes<S> {
    /// Makes stripes with so many to a unit of each texture coordinate.
    pub const fn new(even: Rgb<S>, odd: Rgb<S>, per_unit: [S; 2]) -> Self {
        Self { even, odd, per_unit }
    }
}

impl<S: Scalar> Stripes<S> {
    /// Answers the colour of the stripe at texture coordinates.
    pub fn color(&self, u: S, v: S) -> Rgb<S> {
        if self.tile(u, v) & 1 == 0 { self.even } else { self.odd }
    }

    /// Answers a number of the stripe at texture coordinates.
    pub fn tile(&self, u: S, v: S) -> u32 {
        let [a, b] = self.per_unit;
        S::floor(u.mul_wide(a) + v.mul_wide(b)) as u32
    }

    /// Tells whether every value is one a scene may contain.
    pub fn in_range(&self) -> bool {
        self.even.in_range() && self.odd.in_range() && self.per_unit.iter().all(|count| count.in_range())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stripes_alternate_across_their_direction_and_run_on_along_it() {
        let slanting = Stripes::new(Rgb::WHITE, Rgb::BLACK, [2.0_f32, 1.0]);
        for n in -6..6_i32 {
            let across = 0.25 * n as f32 + 0.125;
            for along in [-3.0, 0.0, 0.5, 7.0] {
                // 2 u + v is twice `across`, wherever along the stripe.
                let color = slanting.color(across - 0.5 * along, along);
                assert_eq!(color == Rgb::WHITE, n.div_euclid(2) % 2 == 0, "{n} at {along}");
            }
        }
    }
}
