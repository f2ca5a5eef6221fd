use super::march::Bracket;
use crate::math::{Scalar, Wide};

/// Is a cubic polynomial over 0 to 1, by the four values that draw it (de Casteljau 1959): it lies between the least
/// and the largest of them, and begins and ends at the first and the last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cubic<S>(pub [S; 4]);

impl<S: Scalar> Cubic<S> {
    /// Answers the value at a place.
    fn at(&self, s: S) -> S {
        let between = |a: S, b: S| a.add_product(b - a, s);
        let [a, b, c, d] = self.0;
        let (ab, bc, cd) = (between(a, b), between(b, c), between(c, d));
        between(between(ab, bc), between(bc, cd))
    }

    /// Answers where the polynomial turns between 0 and 1, in order: at most two places, 1 for each that there is
    /// not.
    fn turns(&self) -> [S; 2] {
        // A third of its derivative is `p s^2 + 2 q s + r`.
        let [a, b, c, d] = self.0;
        let r = b - a;
        let q = (c - b) - r;
        let p = (d - c) - (c - b) - q;
        let square = q.mul_wide(q) - p.mul_wide(r);
        if square < S::Wide::ZERO {
            return [S::ONE; 2];
        }
        let root = S::sqrt(square);
        // The sum of two numbers of one sign: nothing cancels (Press and others, *Numerical Recipes*, 5.6).
        let sum = if q < S::ZERO { root - q } else { -(root + q) };
        let inside = |s: S| if s > S::ZERO && s < S::ONE { s } else { S::ONE };
        let (first, second) = (inside(sum.ratio(p)), inside(r.ratio(sum)));
        [first.min(second), first.max(second)]
    }

    /// Finds the first place where the polynomial changes to the other side of 0: from `inside`, where it is not
    /// below 0, or to there; its first value is on the side told.
    ///
    /// Between its turns it only rises or only falls, so that their sides and that of the end miss nothing (Marmitt
    /// and others 2004); between two of them the place is found by halving, to the last digit.
    ///
    /// Called, not inlined: what a search takes is not on the stack of the way to it.
    #[inline(never)]
    pub fn first_change(&self, inside: bool) -> Option<S> {
        let [turn, back] = self.turns();
        let mut before = S::ZERO;
        for (behind, value) in [(turn, self.at(turn)), (back, self.at(back)), (S::ONE, self.0[3])] {
            if (value >= S::ZERO) != inside {
                let bracket = Bracket::between(before, behind, inside);
                return Some(bracket.narrow(|s| self.at(s) >= S::ZERO));
            }
            before = behind;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fixed;

    /// Answers the four values that draw `(s - a) (s - b) (s - c)`, times a factor.
    fn through([a, b, c]: [f64; 3], factor: f64) -> [f64; 4] {
        let power = [-a * b * c, a * b + b * c + c * a, -(a + b + c), 1.0].map(|x| factor * x);
        let [p, q, r, s] = power;
        [p, p + q / 3.0, p + 2.0 * q / 3.0 + r / 3.0, p + q + r + s]
    }

    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64, precision: f64) {
        let first = |roots: [f64; 3], factor: f64| {
            let values = through(roots, factor);
            let cubic = Cubic(values.map(make));
            cubic.first_change(values[0] >= 0.0).map(read)
        };
        let near = |found: Option<f64>, root: f64| {
            let found = found.expect("a root");
            assert!((found - root).abs() < precision, "{found} instead of {root}");
        };
        // One root, two near each other, three; of both signs.
        for factor in [200.0, -200.0] {
            near(first([0.25, 3.0, 5.0], factor), 0.25);
            near(first([0.5, 0.52, -3.0], factor), 0.5);
            near(first([0.9, 0.6, 0.3], factor), 0.3);
            near(first([0.97, 4.0, -4.0], factor), 0.97);
            assert_eq!(first([1.5, -0.2, -3.0], factor), None);
        }
    }

    #[test]
    fn the_first_of_up_to_three_roots_is_found() {
        check(|x| x as f32, f64::from, 1e-4);
        check(Fixed::new, Fixed::to_f64, 1e-4);
        check(|x| x, |x| x, 1e-13);
    }

    #[test]
    fn an_end_on_the_other_side_is_never_missed() {
        let numbers = |seed: u32| {
            (1..400_u32).map(move |i| f64::from((i * seed).wrapping_mul(0x9e37_79b9) >> 8) / 65_536.0 - 128.0)
        };
        let fours = numbers(1).zip(numbers(3)).zip(numbers(7).zip(numbers(11)));
        let mut changed = 0;
        for ((a, b), (c, d)) in fours {
            // As steep and as flat as 8 bits can be.
            for scale in [1.0, 1e-5] {
                let values = [a, b, c, d].map(|value| Fixed::new(value * scale));
                let inside = values[0] >= Fixed::ZERO;
                if (values[3] >= Fixed::ZERO) != inside {
                    changed += 1;
                    assert!(Cubic(values).first_change(inside).is_some(), "{values:?}");
                }
            }
        }
        assert!(changed > 300, "{changed}");
    }
}
