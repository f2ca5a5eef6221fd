//! Skies of a scene file.
//!
//! To add one: a variant, and an arm in each of the two functions.

use super::image::{Filter, ImageFile};
use super::value::{Color, Point, UP, point, unless};
use crate::rounded::Rounded;
use scanray::Cube;
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
    /// Images on the six faces of a cube that is infinitely far away.
    Cube {
        /// Image seen toward low x.
        low_x: ImageFile,
        /// Image seen toward high x.
        high_x: ImageFile,
        /// Image seen toward low y.
        low_y: ImageFile,
        /// Image seen toward high y.
        high_y: ImageFile,
        /// Image seen toward low z.
        low_z: ImageFile,
        /// Image seen toward high z.
        high_z: ImageFile,
        /// How the colour between texels is found.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        filter: Option<Filter>,
    },
}

impl Sky {
    /// Lists its images, each with a word for what it is for.
    pub fn images_mut(&mut self) -> Vec<(&'static str, &mut ImageFile)> {
        match self {
            Self::Cube { low_x, high_x, low_y, high_y, low_z, high_z, .. } => vec![
                ("low-x", low_x),
                ("high-x", high_x),
                ("low-y", low_y),
                ("high-y", high_y),
                ("low-z", low_z),
                ("high-z", high_z),
            ],
            Self::Solid { .. } | Self::Gradient { .. } => vec![],
        }
    }

    /// Makes the core's sky, rounded to a number.
    ///
    /// The list of faces that the core's cube borrows stays in memory as long as the program runs.
    pub fn in_number<S: Rounded>(&self) -> scanray::Sky<S> {
        match *self {
            Self::Solid { color } => scanray::Sky::Solid(color.in_number()),
            Self::Gradient { up, nadir, zenith } => scanray::Sky::Gradient {
                up: point(up.unwrap_or(UP)),
                nadir: nadir.in_number(),
                zenith: zenith.in_number(),
            },
            Self::Cube { ref low_x, ref high_x, ref low_y, ref high_y, ref low_z, ref high_z, filter } => {
                let faces = [low_x, high_x, low_y, high_y, low_z, high_z].map(|face| face.bitmap);
                let cube = Cube::new(Box::leak(Box::new(faces)));
                scanray::Sky::Cube(cube.with_filter(filter.map_or(cube.filter, Filter::in_core)))
            }
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
            scanray::Sky::Cube(cube) => {
                let [low_x, high_x, low_y, high_y, low_z, high_z] = cube.faces.map(ImageFile::of);
                let filter = unless(Cube::new(cube.faces).filter, cube.filter).map(Filter::of);
                Self::Cube { low_x, high_x, low_y, high_y, low_z, high_z, filter }
            }
            _ => return None,
        })
    }
}
