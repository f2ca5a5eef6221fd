//! Sources of light.

mod spot;

pub use spot::Spot;

use crate::color::Rgb;
use crate::math::{Scalar, Vec3};

/// Is a source of light without extent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Light<S = f32> {
    /// Shines from a point in all directions, the same at any distance (row L6).
    Point {
        /// Where it is.
        position: Vec3<S>,
        /// How much light arrives.
        color: Rgb<S>,
    },
    /// Shines from infinitely far away (row L6).
    Directional {
        /// Where the light comes from, of any length but zero.
        toward: Vec3<S>,
        /// How much light arrives.
        color: Rgb<S>,
    },
    /// Shines from a point into a cone (row L6).
    Spot(Spot<S>),
}

impl<S: Scalar> Light<S> {
    /// Makes a light at a point.
    pub const fn point(position: Vec3<S>, color: Rgb<S>) -> Self {
        Self::Point { position, color }
    }

    /// Makes a light that comes from a direction of any length.
    pub const fn directional(toward: Vec3<S>, color: Rgb<S>) -> Self {
        Self::Directional { toward, color }
    }

    /// Makes a lamp that shines along an axis of any length into a cone, whose edge is at the angle of
    /// which `cutoff` is the cosine; off the axis its light falls with the cosine to the power of
    /// `falloff`.
    ///
    /// ```
    /// use scanray::math::cosine;
    /// use scanray::{Light, Rgb, Vec3};
    /// const DOWN: Vec3 = Vec3::new(0.0, -1.0, 0.0);
    /// static LAMP: Light = Light::spot(Vec3::new(0.0, 5.0, 0.0), DOWN, cosine(25.0) as f32, 8, Rgb::WHITE);
    /// ```
    pub const fn spot(position: Vec3<S>, axis: Vec3<S>, cutoff: S, falloff: u16, color: Rgb<S>) -> Self {
        Self::Spot(Spot { position, axis, cutoff, falloff, color })
    }

    /// Answers how much light arrives from a direction, given toward the light and of unit length; `None`
    /// outside of a [`Spot`]'s cone.
    pub fn arriving(&self, to_light: Vec3<S>) -> Option<Rgb<S>> {
        match self {
            Self::Point { color, .. } | Self::Directional { color, .. } => Some(*color),
            Self::Spot(spot) => {
                let share = spot.share(to_light);
                (share > S::ZERO).then(|| spot.color * share)
            }
        }
    }

    /// Answers how much light arrives at most: of a [`Spot`] on its axis, of the others everywhere.
    pub fn color(&self) -> Rgb<S> {
        match *self {
            Self::Point { color, .. } | Self::Directional { color, .. } | Self::Spot(Spot { color, .. }) => {
                color
            }
        }
    }
}
