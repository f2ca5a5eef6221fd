//! Textures of a scene file.
//!
//! To add one: a variant, and an arm in each of the two functions.

use super::image::Image;
use super::value::Color;
use crate::rounded::Rounded;
use scanray::{Checker, Rings, Stripes, Vertices};
use serde::{Deserialize, Serialize};

/// Is what colours a surface has from place to place; its fields are those of the core's texture of the
/// same name. A single colour is no texture here: a material takes it by itself.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Texture {
    /// A chessboard over the shape's texture coordinates.
    Checker {
        /// Colour of the tile at the origin.
        even: Color,
        /// Colour of its neighbours.
        odd: Color,
        /// Tiles to a unit of the texture coordinates.
        per_unit: f64,
    },
    /// Stripes over the shape's texture coordinates.
    Stripes {
        /// Colour of the stripe at the origin.
        even: Color,
        /// Colour of its neighbours.
        odd: Color,
        /// Stripes to a unit of each texture coordinate.
        per_unit: [f64; 2],
    },
    /// Rings over the shape's texture coordinates.
    Rings {
        /// Colour of the innermost.
        even: Color,
        /// Colour of the one around it.
        odd: Color,
        /// Texture coordinates of their middle.
        center: [f64; 2],
        /// Rings to a unit of the texture coordinates.
        per_unit: f64,
    },
    /// Colours of a triangle's corners, mixed between them.
    Vertices {
        /// Colour of the first corner.
        a: Color,
        /// Colour of the second corner.
        b: Color,
        /// Colour of the third corner.
        c: Color,
    },
    /// An image over the shape's texture coordinates.
    Image(Image),
}

impl Texture {
    /// Makes the core's texture, rounded to a number.
    pub fn in_number<S: Rounded>(&self) -> scanray::Texture<S> {
        match *self {
            Self::Image(ref image) => scanray::Texture::Image(image.in_number()),
            Self::Checker { even, odd, per_unit } => {
                scanray::Texture::Checker(Checker::new(even.in_number(), odd.in_number(), S::round(per_unit)))
            }
            Self::Stripes { even, odd, per_unit } => {
                let per_unit = per_unit.map(S::round);
                scanray::Texture::Stripes(Stripes::new(even.in_number(), odd.in_number(), per_unit))
            }
            Self::Rings { even, odd, center, per_unit } => {
                let (center, per_unit) = (center.map(S::round), S::round(per_unit));
                scanray::Texture::Rings(Rings::new(even.in_number(), odd.in_number(), center, per_unit))
            }
            Self::Vertices { a, b, c } => {
                scanray::Texture::Vertices(Vertices::new(a.in_number(), b.in_number(), c.in_number()))
            }
        }
    }

    /// Takes a texture of the core; `None` for one that scene files do not know.
    pub fn of(texture: &scanray::Texture<f64>) -> Option<Self> {
        Some(match texture {
            scanray::Texture::Checker(board) => Self::Checker {
                even: Color::of(board.even),
                odd: Color::of(board.odd),
                per_unit: board.per_unit,
            },
            scanray::Texture::Stripes(stripes) => Self::Stripes {
                even: Color::of(stripes.even),
                odd: Color::of(stripes.odd),
                per_unit: stripes.per_unit,
            },
            scanray::Texture::Rings(rings) => Self::Rings {
                even: Color::of(rings.even),
                odd: Color::of(rings.odd),
                center: rings.center,
                per_unit: rings.per_unit,
            },
            scanray::Texture::Vertices(mixed) => {
                let [a, b, c] = mixed.colors.map(Color::of);
                Self::Vertices { a, b, c }
            }
            scanray::Texture::Image(image) => Self::Image(Image::of(image)),
            _ => return None,
        })
    }
}
