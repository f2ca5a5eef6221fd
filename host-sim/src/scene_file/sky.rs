//! Skies of a scene file.
//!
//! To add one: a variant, and an arm in each of the two functions.

use super::value::{Color, Point, UP, point, unless};
use crate::rounded::Rounded;
use serde::{Deserialize, Serialize};

/// Is what lies around the scene; its fields are those of the core's sky of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Sky {
    /// The same light everywhere.
    Solid {
        /// The light.
        color: Color,
    },
    /// Light that changes with the height of the direction.
    Gradient {
        /// Unit vector toward the zenith; by default along y.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        up: Option<Point>,
        /// Light from straight below.
        nadir: Color,
        /// Light from straight above.
        zenith: Color,
    },
}

impl Sky {
    /// Makes the core's sky, rounded to a number.
    pub fn in_number<S: Rounded>(&self) -> scanray::Sky<S> {
        match *self {
            Self::Solid { color } => scanray::Sky::Solid(color.in_number()),
            Self::Gradient { up, nadir, zenith } => scanray::Sky::Gradient {
                up: point(up.unwrap_or(UP)),
                nadir: nadir.in_number(),
                zenith: zenith.in_number(),
            },
        }
    }

    /// Takes a sky of the core; `None` for one that scene files do not know.
    pub fn of(sky: &scanray::Sky<f64>) -> Option<Self> {
        Some(match *sky {
            scanray::Sky::Solid(color) => Self::Solid { color: Color::of(color) },
            scanray::Sky::Gradient { up, nadir, zenith } => Self::Gradient {
                up: unless(UP, up.to_array()),
                nadir: Color::of(nadir),
                zenith: Color::of(zenith),
            },
            _ => return None,
        })
    }
}
