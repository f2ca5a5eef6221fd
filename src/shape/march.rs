//! Where a ray first crosses a surface of which only the sides are known.

use crate::math::Scalar;

/// Is the most steps of a search.
pub(super) const STEPS: usize = 200;

/// Is a short piece of a ray that ends on the other side of a surface.
pub(super) struct Bracket<S> {
    before: S,
    behind: S,
    /// Whether the ray comes from inside.
    pub from_inside: bool,
}

/// Finds the first step of a ray, from distance `near` on the side told to `far`, that ends on the
/// other side; at most [`STEPS`] are taken.
///
/// What the ray enters and leaves again within a step is not seen.
pub(super) fn bracket<S: Scalar>(
    [near, far]: [S; 2],
    step: S,
    from_inside: bool,
    inside: impl Fn(S) -> bool,
) -> Option<Bracket<S>> {
    let mut before = near;
    for _ in 0..STEPS {
        if before >= far {
            return None;
        }
        let behind = (before + step).min(far);
        if inside(behind) != from_inside {
            return Some(Bracket { before, behind, from_inside });
        }
        before = behind;
    }
    None
}

impl<S: Scalar> Bracket<S> {
    /// Makes a piece of which the far end is known to be on the other side.
    pub fn between(before: S, behind: S, from_inside: bool) -> Self {
        Self { before, behind, from_inside }
    }

    /// Answers the distance of the surface, to the last digit of the number: at most 64 halvings.
    pub fn narrow(self, inside: impl Fn(S) -> bool) -> S {
        let Self { mut before, mut behind, from_inside } = self;
        for _ in 0..64 {
            let middle = before + (behind - before) * S::HALF;
            if middle <= before || middle >= behind {
                break;
            }
            if inside(middle) == from_inside { before = middle } else { behind = middle }
        }
        before
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fixed;

    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64, precision: f64) {
        // Inside from 3.3 to 3.4 and from 5 on.
        let inside = |t: S| (3.3..3.4).contains(&read(t)) || read(t) >= 5.0;
        let first = |step: f64, near: f64, far: f64, from_inside| {
            let found = bracket([make(near), make(far)], make(step), from_inside, inside);
            found.map(|bracket| read(bracket.narrow(inside)))
        };
        assert!((first(0.05, 0.0, 9.0, false).expect("the thin one") - 3.3).abs() < precision);
        assert!((first(0.05, 3.35, 9.0, true).expect("its back") - 3.4).abs() < precision);
        assert!((first(0.5, 0.0, 9.0, false).expect("the thick one") - 5.0).abs() < precision);
        assert_eq!(first(0.05, 0.0, 3.0, false), None);
        assert_eq!(first(0.015, 0.0, 9.0, false), None, "200 steps are not far enough");
    }

    #[test]
    fn the_first_crossing_no_thinner_than_a_step_is_found_to_the_last_digit() {
        check(|x| x as f32, f64::from, 1e-6);
        check(Fixed::new, Fixed::to_f64, 2e-6);
        check(|x| x, |x| x, 1e-14);
    }
}
