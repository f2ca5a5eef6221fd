//! Bumps of a scene file.
//!
//! To add one: a variant, and an arm in each of the functions.

use super::image::Image;
use crate::rounded::Rounded;
use scanray::Relief;
use serde::{Deserialize, Serialize};

/// Is roughness that only light sees; its variants are those of the core's relief of a bump.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Bump {
    /// A map of heights above the surface.
    Heights {
        /// The map: black is 0, green at its full level `height`.
        image: Image,
        /// The height of the highest.
        height: f64,
    },
    /// A map of normals.
    Normals {
        /// The map: red, green and blue are a normal's parts along u, along v and outward.
        image: Image,
    },
}

impl Bump {
    /// Makes the core's bumps, rounded to a number.
    pub fn in_number<S: Rounded>(&self) -> scanray::Bump<S> {
        match self {
            Self::Heights { image, height } => scanray::Bump::heights(image.in_number(), S::round(*height)),
            Self::Normals { image } => scanray::Bump::normals(image.in_number()),
        }
    }

    /// Takes bumps of the core; `None` for those that scene files do not know.
    pub fn of(bump: &scanray::Bump<f64>) -> Option<Self> {
        let image = Image::of(&bump.image);
        match bump.relief {
            Relief::Heights(height) => Some(Self::Heights { image, height }),
            Relief::Normals => Some(Self::Normals { image }),
            _ => None,
        }
    }

    /// Answers its image, with a word for what it is for.
    pub fn image_mut(&mut self) -> (&'static str, &mut Image) {
        match self {
            Self::Heights { image, .. } => ("heights", image),
            Self::Normals { image } => ("normals", image),
        }
    }
}
