//! How a mesh stands in a scene.

use super::ready::Unusable;
use super::value::Point;
use crate::model::Corner;

/// Is the largest magnitude of a field: what is as large has no place in any number.
const LARGEST: f64 = 1e12;

/// Is how triangles are scaled, then turned, then moved. What is not given changes no bit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Placement {
    /// Where the origin goes.
    pub at: Option<Point>,
    /// What a unit becomes, above 0.
    pub scale: Option<f64>,
    /// Degrees about x, then about y, then about z, anticlockwise as seen from the axis's far end.
    pub turn: Option<Point>,
}

impl Placement {
    /// Scales, turns and moves corners.
    ///
    /// # Errors
    /// A field that is no number, or too large, or a scale that is not above 0.
    pub fn apply(&self, corners: &mut [Corner]) -> Result<(), Unusable> {
        let usable = |value: &f64| value.abs() <= LARGEST;
        if !self.scale.iter().all(|scale| *scale > 0.0 && usable(scale)) {
            return Err(Unusable::Scale);
        }
        if !self.at.iter().chain(&self.turn).flatten().all(usable) {
            return Err(Unusable::TooLarge);
        }
        let turns = self.turn.map(|degrees| degrees.map(sine_and_cosine));
        for corner in corners {
            if let Some(scale) = self.scale {
                corner.place = corner.place.map(|value| value * scale);
            }
            if let Some(turns) = &turns {
                corner.place = turned(corner.place, turns);
                corner.normal = corner.normal.map(|normal| turned(normal, turns));
            }
            if let Some(at) = self.at {
                corner.place = std::array::from_fn(|axis| corner.place[axis] + at[axis]);
            }
        }
        Ok(())
    }
}

/// Turns a vector about each axis, one after the other.
fn turned(mut v: Point, turns: &[[f64; 2]; 3]) -> Point {
    for (axis, [sine, cosine]) in turns.iter().enumerate() {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        (v[j], v[k]) = (cosine * v[j] - sine * v[k], sine * v[j] + cosine * v[k]);
    }
    v
}

/// Answers sine and cosine of an angle in degrees; those of right angles are whole.
fn sine_and_cosine(degrees: f64) -> [f64; 2] {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    if degrees % 90.0 == 0.0 { [sine.round(), cosine.round()] } else { [sine, cosine] }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn placed(placement: Placement) -> Corner {
        let mut corner = Corner { place: [1.0, 2.0, 3.0], normal: Some([1.0, 0.0, 0.0]), texture: None };
        placement.apply(std::slice::from_mut(&mut corner)).expect("it can be placed");
        corner
    }

    #[test]
    fn a_quarter_turn_about_an_axis_takes_the_next_axis_to_the_one_behind_it() {
        let about_y = placed(Placement { turn: Some([0.0, 90.0, 0.0]), ..Placement::default() });
        assert_eq!((about_y.place, about_y.normal), ([3.0, 2.0, -1.0], Some([0.0, 0.0, -1.0])));
        let about_z = placed(Placement { turn: Some([0.0, 0.0, -270.0]), ..Placement::default() });
        assert_eq!((about_z.place, about_z.normal), ([-2.0, 1.0, 3.0], Some([0.0, 1.0, 0.0])));
        let about_x_then_z = placed(Placement { turn: Some([90.0, 0.0, 90.0]), ..Placement::default() });
        assert_eq!(about_x_then_z.place, [3.0, 1.0, 2.0]);
    }

    #[test]
    fn what_is_scaled_and_moved_is_scaled_first_and_normals_keep_their_length() {
        let both = Placement { at: Some([10.0, 0.0, 0.0]), scale: Some(2.0), turn: Some([0.0, 0.0, 180.0]) };
        assert_eq!(placed(both).place, [8.0, -4.0, 6.0]);
        assert_eq!(placed(both).normal, Some([-1.0, 0.0, 0.0]));
    }

    #[test]
    fn what_is_no_number_or_too_large_is_refused() {
        let refusal = |placement: Placement| placement.apply(&mut []).unwrap_err();
        for scale in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(refusal(Placement { scale: Some(scale), ..Placement::default() }), Unusable::Scale);
        }
        let far = Some([0.0, f64::NAN, 0.0]);
        assert_eq!(refusal(Placement { at: far, ..Placement::default() }), Unusable::TooLarge);
        assert_eq!(refusal(Placement { turn: far, ..Placement::default() }), Unusable::TooLarge);
    }
}
