//! Glass: light that goes through a surface, bent (rows R2 and R3).

use crate::color::Rgb;
use crate::fault::Fault;
use crate::math::{Scalar, Vec3, Wide};

/// Is what a surface lets through, and what the inside does to it.
///
/// The inside is where the normal does not point to: only shapes that bound a body can be of glass, each
/// by itself. One may stand wholly inside another; what it stands in is found where light passes its
/// surface. Where the eye is inside of glass, what it sees before a ray's first surface of glass, directly or
/// in mirrors, keeps its colour.
///
/// ```
/// use scanray::{Fresnel, Glass, Material, Rgb};
/// const GREEN_GLASS: Material = Material::matte(Rgb::BLACK).with_glass(
///     Glass::new(1.0, 1.5).with_fresnel(Fresnel::Exact).with_absorption(Rgb::new(0.9, 0.1, 0.6)),
/// );
/// assert_eq!(GREEN_GLASS.check(), Ok(()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Glass<S = f32> {
    /// Weight of the light that comes through, `1 - o` of row R3; with the mirror's weight at most 1.
    pub transmission: S,
    /// Refractive index of the inside, from 1/8 to 8; that of the space around all is 1.
    pub index: S,
    /// What of the light turns back at the surface.
    pub fresnel: Fresnel,
    /// Share of the light lost in a short way, to a unit of that way (Beer's law): `exp(-a t)` is
    /// left after a way of t units.
    pub absorption: Rgb<S>,
}

/// Names the share of the transmitted light that turns back at a surface instead.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Fresnel {
    /// None but what the mirror's weight says, and all of it where none can get through.
    #[default]
    None,
    /// `r0 + (1 - r0) (1 - cos)^5` (Schlick 1994), within 0.07 of the exact share from air into
    /// indices of 1.3 to 2.
    Schlick,
    /// The mean of both polarisations (Fresnel's equations for dielectrics).
    Exact,
}

impl<S: Scalar> Glass<S> {
    /// Makes clear glass that lets a share of the light through.
    pub const fn new(transmission: S, index: S) -> Self {
        Self { transmission, index, fresnel: Fresnel::None, absorption: Rgb::BLACK }
    }

    /// Sets what of the light turns back.
    pub const fn with_fresnel(mut self, fresnel: Fresnel) -> Self {
        self.fresnel = fresnel;
        self
    }

    /// Colours the inside.
    pub const fn with_absorption(mut self, absorption: Rgb<S>) -> Self {
        self.absorption = absorption;
        self
    }

    /// Answers the share of each light that is left after a way through the inside.
    pub fn left_after(&self, way: S) -> Rgb<S> {
        let Rgb { r, g, b } = self.absorption * way;
        Rgb::new(r.exp_neg(), g.exp_neg(), b.exp_neg())
    }

    /// Tells what is wrong with the glass under a mirror's weight, if anything.
    ///
    /// # Errors
    /// A value that no scene may contain, more light than arrives, an index out of its range.
    pub fn check(&self, mirror: S) -> Result<(), Fault> {
        let eighth = S::HALF * S::HALF * S::HALF;
        if !self.absorption.in_range() {
            Err(Fault::OutOfRange)
        } else if !(self.transmission >= S::ZERO && mirror + self.transmission <= S::ONE + S::SLACK) {
            Err(Fault::Transmission)
        } else if self.index >= eighth && self.index <= S::from_i32(8) {
            Ok(())
        } else {
            Err(Fault::RefractiveIndex)
        }
    }
}

impl Fresnel {
    /// Answers the share that turns back between indices `[from, to]` at the cosines `[incoming,
    /// refracted]` to the normal, from 0 to 1.
    pub fn reflectance<S: Scalar>(self, [from, to]: [S; 2], [incoming, refracted]: [S; 2]) -> S {
        let square = |x: S| x * x;
        match self {
            Self::None => S::ZERO,
            Self::Schlick => {
                let straight = square((from - to).ratio(from + to));
                // From the denser side the angle in the thinner one counts.
                let cosine = if from > to { refracted } else { incoming };
                let slant = (S::ONE - cosine).max(S::ZERO);
                straight + (S::ONE - straight) * square(square(slant)) * slant
            }
            Self::Exact => {
                let share = |a: S, b: S| square((a - b).ratio(a + b));
                let across = share(from * incoming, to * refracted);
                let along = share(from * refracted, to * incoming);
                ((across + along) * S::HALF).min(S::ONE)
            }
        }
    }
}

/// Bends a unit direction at a unit normal on its own side, `ratio` being the index it comes from
/// over the one it goes to: Snell's law in the vectors of row R2.
///
/// Answers the new unit direction and its cosine to the normal; `None` where all light turns back.
pub fn refract<S: Scalar>(direction: Vec3<S>, normal: Vec3<S>, ratio: S) -> Option<(Vec3<S>, S)> {
    let cosine = -direction.dot(normal);
    // Along the surface: as long as the sine of the new angle.
    let tangent = direction.add_scaled(normal, cosine) * ratio;
    let square = S::ONE.mul_wide(S::ONE) - tangent.dot_wide(tangent);
    if square < S::Wide::ZERO {
        return None;
    }
    let refracted = S::sqrt(square);
    Some((tangent.add_scaled(normal, -refracted).straighten(), refracted))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Fixed;

    const UP: Vec3<f64> = Vec3::new(0.0, 1.0, 0.0);

    fn root(square: f64) -> f64 {
        <f64 as Scalar>::sqrt(square)
    }

    /// Falls at an angle with this sine.
    fn falling(sine: f64) -> Vec3<f64> {
        Vec3::new(sine, -root(1.0 - sine * sine), 0.0)
    }

    #[test]
    fn sines_are_as_the_indices_on_both_sides() {
        for sine in [0.0, 0.1, 0.5, 0.9, 0.999] {
            let (bent, cosine) = refract(falling(sine), UP, 1.0 / 1.5).expect("goes through");
            assert!((bent.x - sine / 1.5).abs() < 1e-12 && (cosine + bent.y).abs() < 1e-12);
            assert!((bent.length() - 1.0).abs() < 1e-12);
            // And back: the way of light can be turned round.
            let (back, _) = refract(bent, UP, 1.5).expect("goes through");
            assert!((back - falling(sine)).length() < 1e-9);
        }
    }

    #[test]
    fn beyond_the_critical_angle_nothing_gets_through() {
        let critical = 1.0 / 1.5;
        assert!(refract(falling(critical - 1e-6), UP, 1.5).is_some());
        assert!(refract(falling(critical + 1e-6), UP, 1.5).is_none());
    }

    #[test]
    fn equal_indices_bend_and_reflect_nothing() {
        let (same, cosine) = refract(falling(0.6), UP, 1.0).expect("goes through");
        assert!((same - falling(0.6)).length() < 1e-12);
        for fresnel in [Fresnel::None, Fresnel::Exact] {
            assert!(fresnel.reflectance([1.3, 1.3], [0.8, cosine]) < 1e-12);
        }
    }

    #[test]
    fn reflectance_has_its_known_values() {
        // Straight on, ((n - 1) / (n + 1))^2: 4 % for glass of 1.5.
        for fresnel in [Fresnel::Schlick, Fresnel::Exact] {
            assert!((fresnel.reflectance([1.0, 1.5], [1.0, 1.0]) - 0.04_f64).abs() < 1e-12);
            assert!((fresnel.reflectance([1.5, 1.0], [1.0, 1.0]) - 0.04_f64).abs() < 1e-12);
            assert!((fresnel.reflectance([1.0, 1.5], [0.0, 0.745]) - 1.0_f64).abs() < 1e-12);
        }
        // At Brewster's angle, tan = n, only one polarisation turns back: ((n^2 - 1) / (n^2 + 1))^2 / 2.
        let length = root(1.0 + 1.5 * 1.5);
        let share = Fresnel::Exact.reflectance([1.0, 1.5], [1.0 / length, 1.5 / length]);
        assert!((share - (1.25_f64 / 3.25) * (1.25 / 3.25) / 2.0).abs() < 1e-12);
    }

    #[test]
    fn schlick_stays_near_the_exact_share() {
        let mut worst = 0.0_f64;
        for n in [1.3, 1.5, 1.8, 2.0] {
            for step in 0..=1000 {
                let sine = f64::from(step) / 1000.0;
                let cosines = [1.0 - sine * sine, 1.0 - sine * sine / (n * n)].map(root);
                let share = |fresnel: Fresnel| fresnel.reflectance([1.0, n], cosines);
                worst = worst.max((share(Fresnel::Schlick) - share(Fresnel::Exact)).abs());
            }
        }
        assert!((0.06..0.07).contains(&worst), "{worst}");
    }

    #[test]
    fn what_two_ways_leave_is_the_product_of_what_each_leaves() {
        let glass = Glass::new(1.0, 1.5).with_absorption(Rgb::new(0.3, 2.0, 0.0));
        let (near, far, both) = (glass.left_after(0.7), glass.left_after(1.9), glass.left_after(2.6));
        assert!(f64::abs(near.r * far.r - both.r) < 1e-12 && f64::abs(near.g * far.g - both.g) < 1e-12);
        assert_eq!(both.b, 1.0);
    }

    #[test]
    fn fixed_point_bends_within_a_few_steps() {
        for sine in [0.0, 0.2, 0.6, 0.95] {
            let d = falling(sine);
            let fixed = Vec3::from_f64(d.x, d.y, d.z);
            let up = Vec3::from_f64(0.0, 1.0, 0.0);
            let (bent, _) = refract(fixed, up, Fixed::new(1.0 / 1.5)).expect("goes through");
            assert!((bent.x.to_f64() - sine / 1.5).abs() < 4e-6);
        }
    }

    #[test]
    fn impossible_glass_is_refused() {
        let check = |transmission: f32, index| Glass::new(transmission, index).check(0.25);
        assert_eq!(check(0.75, 1.5), Ok(()));
        assert_eq!(check(0.8, 1.5), Err(Fault::Transmission));
        assert_eq!(check(f32::NAN, 1.5), Err(Fault::Transmission));
        assert_eq!(check(-0.1, 1.5), Err(Fault::Transmission));
        assert_eq!(check(0.5, 0.1), Err(Fault::RefractiveIndex));
        assert_eq!(check(0.5, f32::NAN), Err(Fault::RefractiveIndex));
        let dark = Glass::new(0.5_f32, 1.5).with_absorption(Rgb::gray(-1.0));
        assert_eq!(dark.check(0.0), Err(Fault::OutOfRange));
    }
}
