use super::fixed::Fixed;
use super::vec3::Vec3;

/// Is how the lengths of a scene are brought into the range where [`Fixed`] has its digits.
///
/// A scene in millimetres may be 20000 wide, one in metres 0.02: the first does not fit a fixed-point
/// number, the second keeps few of its digits. Scaled by a power of two both fill the range, and
/// the picture is the same: it does not know units. Lengths, points and the camera's depths go
/// through [`Units::length`] and [`Units::point`], tiles to a unit through [`Units::per_length`];
/// directions, colours and weights are as they are.
///
/// ```
/// use scanray::math::{Fixed, Scalar, Units};
/// use scanray::{Shape, Sphere};
///
/// const MILLIMETRES: Units = Units::for_largest(20_000.0);
/// static BALL: Shape<Fixed> =
///     Shape::Sphere(Sphere::new(MILLIMETRES.point(0.0, 12_000.0, -20_000.0), MILLIMETRES.length(8_000.0)));
/// assert!(MILLIMETRES.length(20_000.0) <= Fixed::LIMIT);
/// assert_eq!(MILLIMETRES.in_scene(MILLIMETRES.length(8_000.0)), 8_000.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// What a unit of the scene is in fixed point, a power of two.
    scale: f64,
}

impl Units {
    /// Is the range that the largest coordinate is brought into: this, and half of it.
    ///
    /// Half of what a scene may have at most: differences of coordinates keep a bit to spare.
    const TOP: f64 = 512.0;

    /// Makes the units of a scene whose largest coordinate, radius or distance has this magnitude.
    ///
    /// What is 0, infinite or no number leaves lengths as they are.
    pub const fn for_largest(magnitude: f64) -> Self {
        let magnitude = magnitude.abs();
        let mut scale = 1.0;
        if magnitude.is_finite() && magnitude > 0.0 {
            while magnitude * scale > Self::TOP {
                scale /= 2.0;
            }
            while magnitude * scale <= Self::TOP / 2.0 {
                scale *= 2.0;
            }
        }
        Self { scale }
    }

    /// Answers what a unit of the scene is in fixed point, a power of two.
    pub const fn scale(self) -> f64 {
        self.scale
    }

    /// Brings a length of the scene into fixed point, rounded.
    pub const fn length(self, length: f64) -> Fixed {
        Fixed::new(length * self.scale)
    }

    /// Brings a point of the scene into fixed point, rounded.
    pub const fn point(self, x: f64, y: f64, z: f64) -> Vec3<Fixed> {
        Vec3::new(self.length(x), self.length(y), self.length(z))
    }

    /// Brings a number of tiles, or the like, to a unit of length into fixed point, rounded.
    pub const fn per_length(self, count: f64) -> Fixed {
        Fixed::new(count / self.scale)
    }

    /// Brings a length back into the units of the scene.
    pub fn in_scene(self, length: Fixed) -> f64 {
        length.to_f64() / self.scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Scalar;

    #[test]
    fn the_largest_length_fills_the_range_whatever_its_unit() {
        for largest in [1e-6, 0.02, 0.999, 1.0, 3.0, 256.0, 257.0, 512.0, 513.0, 20_000.0, 3.8e8] {
            let filled = Units::for_largest(largest).length(largest);
            assert!(filled > Fixed::new(255.9) && filled <= Fixed::new(512.0), "{largest}: {filled:?}");
            assert!(filled.in_range());
        }
    }

    #[test]
    fn a_length_comes_back_in_the_units_of_the_scene() {
        for largest in [1e-6, 3.0, 20_000.0] {
            let units = Units::for_largest(largest);
            let there_and_back = units.in_scene(units.length(0.7 * largest));
            // Half a step of 2^-20 in 179 is 2.7e-9.
            assert!((there_and_back / (0.7 * largest) - 1.0).abs() < 3e-9, "{largest}: {there_and_back}");
        }
    }

    #[test]
    fn no_largest_length_leaves_lengths_as_they_are() {
        for nothing in [0.0, f64::NAN, f64::INFINITY] {
            assert_eq!(Units::for_largest(nothing).length(3.0), Fixed::new(3.0));
        }
    }
}
