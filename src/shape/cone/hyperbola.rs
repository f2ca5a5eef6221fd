use super::super::called::{product, product_nearest};
use crate::math::{Scalar, Wide};

/// Is a line in the plane of (x, w), where the side of a cone is the hyperbola w^2 - x^2 = beside^2.
pub(super) struct Hyperbola<S> {
    /// A point of the line.
    pub at: [S; 2],
    /// Its direction, of unit length.
    pub toward: [S; 2],
    /// How far from the middle the hyperbola begins.
    pub beside: S,
}

impl<S: Scalar> Hyperbola<S> {
    /// Answers between which distances the line is above the upper branch; it may be above the lower
    /// one instead, of which nothing lies between the ends of a cone.
    pub fn inside(&self) -> Option<[S; 2]> {
        let ([x, w], [to_x, to_w], one) = (self.at, self.toward, S::ONE);
        // a t^2 + 2 b t + c = 0. The discriminant b^2 - a c, but without the products of four
        // lengths, and without a difference where the line is flat, as of a cylinder.
        let a = product(to_x, to_x) - product(to_w, to_w);
        let b = S::determinant([to_x, to_w], [w, x]);
        let c = product(x, x) + product(self.beside, self.beside) - product(w, w);
        let (reach, off) =
            (S::determinant([to_x, to_w], [x, w]), product_nearest(S::sqrt(a.abs()), self.beside));
        let square = product(off, off);
        let rest = product(reach, reach) + if a < S::Wide::ZERO { square } else { -square };
        if rest < S::Wide::ZERO {
            return None;
        }
        let root = S::sqrt(rest);
        // The sum that does not cancel, and the other root by the product of both.
        let sum = if b > S::ZERO { -b - root } else { root - b };
        let (first, second) = (S::div(product(sum, one), a), S::div(c, product(sum, one)));
        let (low, high) = (first.min(second), first.max(second));
        Some(if a >= S::Wide::ZERO {
            [low, high]
        } else if to_w > S::ZERO {
            [high, S::FAR]
        } else {
            [S::FAR_BACK, low]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fixed;

    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let from = |x: f64| {
            let line = Hyperbola {
                at: [make(x), make(100.0 + 1.0 / 1024.0)],
                toward: [S::ONE, S::ZERO],
                beside: S::ZERO,
            };
            line.inside().expect("a line between the branch's arms").map(read)
        };
        // The arms are at x = -100 - 1/1024 and x = 100 + 1/1024.
        let near = |[low, high]: [f64; 2], expected: [f64; 2], [coarse, fine]: [f64; 2]| {
            let off = [(low - expected[0]).abs(), (high - expected[1]).abs()];
            assert!(off[0] < coarse && off[1] < fine, "{low} to {high} instead of {expected:?}");
        };
        near(from(100.0), [-200.0 - 1.0 / 1024.0, 1.0 / 1024.0], [1e-3, 2e-5]);
        near(from(-100.0), [-1.0 / 1024.0, 200.0 + 1.0 / 1024.0], [2e-5, 1e-3]);
    }

    #[test]
    fn beside_a_far_arm_a_near_one_keeps_its_digits() {
        check(|x| x as f32, f64::from);
        check(Fixed::new, Fixed::to_f64);
        check(|x| x, |x| x);
    }
}
