use crate::color::Rgb;
use crate::fault::Fault;
use crate::math::Scalar;

/// Is what a value of a voxel means: one knot of a table that goes on in straight lines (row V1).
///
/// A class that covers a range of values takes two knots; between two classes colour and opacity pass over from
/// one to the other, as the mixture of two tissues in a voxel does (Drebin, Carpenter and Hanrahan 1988).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Class<S = f32> {
    /// The value.
    pub value: u8,
    /// Colour there.
    pub color: Rgb<S>,
    /// Opacity there, of 255: what share of the volume's density it is.
    pub opacity: u8,
}

impl<S: Scalar> Class<S> {
    /// Makes a knot.
    pub const fn new(value: u8, color: Rgb<S>, opacity: u8) -> Self {
        Self { value, color, opacity }
    }

    /// Is the tissues of a body as the lectures class them: transparent air, yellow fat, red muscle and opaque
    /// white bone.
    pub const TISSUES: [Self; 7] = {
        let yellow = Rgb::new(S::ONE, S::ONE, S::ZERO);
        let red = Rgb::new(S::ONE, S::ZERO, S::ZERO);
        [
            Self::new(40, yellow, 0),
            Self::new(70, yellow, 24),
            Self::new(90, yellow, 24),
            Self::new(120, red, 60),
            Self::new(150, red, 60),
            Self::new(220, Rgb::WHITE, 255),
            Self::new(255, Rgb::WHITE, 255),
        ]
    };
}

/// Answers colour and opacity of a value, the opacity from 0 to 255; below the first knot it is that of the first,
/// above the last that of the last.
pub(super) fn classify<S: Scalar>(classes: &[Class<S>], value: S) -> (Rgb<S>, S) {
    let number = |level: u8| S::from_i32(i32::from(level));
    let plain = |class: &Class<S>| (class.color, number(class.opacity));
    let above = classes.partition_point(|class| number(class.value) <= value);
    let lower = above.checked_sub(1).and_then(|below| classes.get(below));
    match (lower, classes.get(above)) {
        (Some(low), Some(high)) => {
            let share = (value - number(low.value)).ratio(number(high.value) - number(low.value));
            let between = |a: S, b: S| a.add_product(b - a, share);
            let (from, to) = (low.color, high.color);
            let color = Rgb::new(between(from.r, to.r), between(from.g, to.g), between(from.b, to.b));
            (color, between(number(low.opacity), number(high.opacity)))
        }
        (Some(only), None) | (None, Some(only)) => plain(only),
        (None, None) => (Rgb::BLACK, S::ZERO),
    }
}

/// Tells whether all values of a range, its ends included, are transparent.
pub(super) fn are_clear<S>(classes: &[Class<S>], [low, high]: [u8; 2]) -> bool {
    let next = classes.iter().skip(1).map(Some).chain([None]);
    let knots = classes.iter().zip(next);
    // A knot matters from the one before it to the one after it, the first and the last without end.
    let mut before = 0;
    for (class, next) in knots {
        let last = next.map_or(u8::MAX, |next| next.value);
        if class.opacity > 0 && before <= high && low <= last {
            return false;
        }
        before = class.value;
    }
    true
}

/// Tells what is wrong with a table, if anything.
pub(super) fn check<S: Scalar>(classes: &[Class<S>]) -> Result<(), Fault> {
    let rising = classes.is_sorted_by(|a, b| a.value < b.value);
    if classes.is_empty() || !rising {
        Err(Fault::Classes)
    } else if classes.iter().all(|class| class.color.in_range()) {
        Ok(())
    } else {
        Err(Fault::OutOfRange)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fixed;

    #[test]
    fn tissues_have_the_colours_of_the_lectures_and_pass_into_each_other() {
        fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
            let look = |value| {
                let (Rgb { r, g, b }, opacity) = classify(&Class::TISSUES, make(value));
                [r, g, b, opacity].map(read)
            };
            let near = |value, expected: [f64; 4]| {
                let seen = look(value);
                assert!(seen.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-4), "{value}: {seen:?}");
            };
            near(0.0, [1.0, 1.0, 0.0, 0.0]);
            near(80.0, [1.0, 1.0, 0.0, 24.0]);
            near(105.0, [1.0, 0.5, 0.0, 42.0]);
            near(135.0, [1.0, 0.0, 0.0, 60.0]);
            near(185.0, [1.0, 0.5, 0.5, 157.5]);
            near(255.0, [1.0, 1.0, 1.0, 255.0]);
        }
        check(|x| x as f32, f64::from);
        check(Fixed::new, Fixed::to_f64);
        check(|x| x, |x| x);
    }

    #[test]
    fn a_range_is_clear_where_no_value_in_it_has_opacity() {
        let class = |value, opacity| Class::<f64>::new(value, Rgb::WHITE, opacity);
        let tables = [
            vec_of([class(40, 0), class(60, 9), class(100, 0), class(200, 0)]),
            vec_of([class(40, 7), class(60, 0), class(61, 0), class(200, 1)]),
        ];
        for table in &tables {
            let step = if cfg!(miri) { 85 } else { 3 };
            let lows = (0..=255_u8).step_by(step);
            for (low, high) in lows.flat_map(|low| (low..=255).map(move |high| (low, high))) {
                let opaque = (low..=high).any(|value| classify(table, f64::from(value)).1 > 0.0);
                // At the very end of a slope the range may be called opaque though only its end touches it.
                let inner =
                    (low.saturating_add(1)..high).any(|value| classify(table, f64::from(value)).1 > 0.0);
                assert!(!(opaque && are_clear(table, [low, high])), "{low} to {high}");
                assert!(
                    inner || are_clear(table, [low, high]) || touches(table, low, high),
                    "{low} to {high}"
                );
            }
        }
    }

    fn vec_of(table: [Class<f64>; 4]) -> [Class<f64>; 4] {
        table
    }

    /// Tells whether a slope of the table reaches into a range, if only by its end.
    fn touches(table: &[Class<f64>], low: u8, high: u8) -> bool {
        [low, high].iter().any(|value| {
            let beside = [value.saturating_sub(1), value.saturating_add(1)];
            beside.iter().any(|value| classify(table, f64::from(*value)).1 > 0.0)
        })
    }

    #[test]
    fn tables_that_do_not_rise_are_refused() {
        let class = |value| Class::new(value, Rgb::WHITE, 1);
        assert_eq!(check::<f32>(&Class::TISSUES), Ok(()));
        assert_eq!(check::<f32>(&[]), Err(Fault::Classes));
        assert_eq!(check::<f32>(&[class(3), class(3)]), Err(Fault::Classes));
        assert_eq!(check(&[Class::new(3, Rgb::gray(-1.0_f32), 1)]), Err(Fault::OutOfRange));
    }
}
