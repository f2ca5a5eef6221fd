use crate::color::Rgb;
use crate::fault::Fault;
use crate::math::{Scalar, Vec3};

/// Is a lamp that shines from a point into a cone, brightest along its axis (row L6).
///
/// At an angle a off the axis, up to the cone's edge, `cos(a)^falloff` of its light arrives, beyond it
/// none: the spotlight of OpenGL 1.0 (Segal and Akeley 1992). Its edge is sharp where that power is still
/// large there.
// Position and colour lie where a point's do: what they are needed for does not ask which light it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot<S = f32> {
    /// Where it is.
    pub position: Vec3<S>,
    /// How much light arrives on the axis.
    pub color: Rgb<S>,
    /// Where it shines to along the middle of its cone, of any length but zero.
    pub axis: Vec3<S>,
    /// Cosine of the angle between axis and edge, from 0 to below 1, as [`cosine`](crate::math::cosine)
    /// answers it for a constant.
    pub cutoff: S,
    /// Exponent of the cosine; 0 for the same light in the whole cone.
    pub falloff: u16,
}

impl<S: Scalar> Spot<S> {
    /// Answers which share of its light comes from a direction, given toward the lamp and of unit length.
    #[inline(never)]
    pub fn share(&self, to_light: Vec3<S>) -> S {
        let Some((axis, _)) = self.axis.normalize() else { return S::ZERO };
        let cosine = -axis.dot(to_light);
        if cosine >= self.cutoff { cosine.pow_unit(self.falloff) } else { S::ZERO }
    }

    /// Tells what is wrong with the lamp, if anything.
    ///
    /// # Errors
    /// A value that no scene may contain, an axis without direction, a cone without opening or wider
    /// than half of space.
    pub fn check(&self) -> Result<(), Fault> {
        if !(self.position.in_range() && self.axis.in_range() && self.color.in_range()) {
            Err(Fault::OutOfRange)
        } else if !(self.cutoff >= S::ZERO && self.cutoff < S::ONE) {
            Err(Fault::Cone)
        } else {
            self.axis.normalize().map(|_| ()).ok_or(Fault::NoDirection)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::cosine;

    const UP: Vec3<f64> = Vec3::new(0.0, 1.0, 0.0);

    /// Makes a lamp that shines straight down.
    fn lamp(degrees: f64, falloff: u16) -> Spot<f64> {
        let axis = Vec3::new(0.0, -7.0, 0.0);
        Spot { position: Vec3::ZERO, axis, cutoff: cosine(degrees), falloff, color: Rgb::WHITE }
    }

    /// Answers the way to the lamp of a place so many degrees off its axis.
    fn from(degrees: f64) -> Vec3<f64> {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        Vec3::new(-sine, cosine, 0.0)
    }

    #[test]
    fn light_falls_with_a_power_of_the_cosine_up_to_the_edge_of_the_cone() {
        assert!((lamp(70.0, 9).share(UP) - 1.0).abs() < 1e-15);
        assert!((lamp(70.0, 2).share(from(60.0)) - 0.25).abs() < 1e-12);
        assert!((lamp(70.0, 4).share(from(45.0)) - 0.25).abs() < 1e-12);
        let falling: [f64; 6] = core::array::from_fn(|i| lamp(60.0, 3).share(from(11.0 * i as f64)));
        assert!(falling.is_sorted_by(|a, b| a > b), "{falling:?}");
    }

    #[test]
    fn beyond_the_edge_and_behind_the_lamp_there_is_no_light() {
        for edge in [1.0, 25.0, 60.0, 90.0] {
            assert_eq!(lamp(edge, 0).share(from(edge - 0.01)), 1.0);
            assert_eq!(lamp(edge, 0).share(from(edge + 0.01)), 0.0);
            assert_eq!(lamp(edge, 0).share(-UP), 0.0);
        }
    }
}
