//! Lights of a scene file.
//!
//! To add one: a variant, and an arm in each of the two functions.

use super::value::{Color, Point, point};
use crate::rounded::Rounded;
use serde::{Deserialize, Serialize};

/// Is a source of light; its fields are those of the core's light of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Light {
    /// Shines from a point in all directions, the same at any distance.
    Point {
        /// Where it is.
        position: Point,
        /// How much light arrives.
        color: Color,
    },
    /// Shines from infinitely far away.
    Directional {
        /// Where the light comes from, of any length but zero.
        toward: Point,
        /// How much light arrives.
        color: Color,
    },
    /// Shines from a point into a cone.
    Spot {
        /// Where it is.
        position: Point,
        /// Where it shines to along the middle of its cone, of any length but zero.
        axis: Point,
        /// Cosine of the angle between axis and edge.
        cutoff: f64,
        /// Exponent with which light falls off the axis.
        falloff: u16,
        /// How much light arrives on the axis.
        color: Color,
    },
}

impl Light {
    /// Makes the core's light, rounded to a number.
    pub fn in_number<S: Rounded>(&self) -> scanray::Light<S> {
        match *self {
            Self::Point { position, color } => scanray::Light::point(point(position), color.in_number()),
            Self::Directional { toward, color } => {
                scanray::Light::directional(point(toward), color.in_number())
            }
            Self::Spot { position, axis, cutoff, falloff, color } => {
                let (position, axis, cutoff) = (point(position), point(axis), S::round(cutoff));
                scanray::Light::spot(position, axis, cutoff, falloff, color.in_number())
            }
        }
    }

    /// Takes a light of the core; `None` for one that scene files do not know.
    pub fn of(light: &scanray::Light<f64>) -> Option<Self> {
        Some(match *light {
            scanray::Light::Point { position, color } => {
                Self::Point { position: position.to_array(), color: Color::of(color) }
            }
            scanray::Light::Directional { toward, color } => {
                Self::Directional { toward: toward.to_array(), color: Color::of(color) }
            }
            scanray::Light::Spot(spot) => Self::Spot {
                position: spot.position.to_array(),
                axis: spot.axis.to_array(),
                cutoff: spot.cutoff,
                falloff: spot.falloff,
                color: Color::of(spot.color),
            },
            _ => return None,
        })
    }
}
