//! Textures: what colours a surface has from place to place, and what bumps.

mod bump;
mod checker;
mod image;
mod procedural;
mod rings;
mod srgb;
mod stripes;
mod texels;
mod vertices;

pub use bump::{Bump, Relief};
pub use checker::Checker;
pub use image::{Filter, Image};
pub use procedural::Procedural;
pub use rings::Rings;
pub use stripes::Stripes;
pub use texels::{Bitmap, Texels};
pub use vertices::Vertices;

pub(crate) use bump::{bend, rise};
pub(crate) use image::{Spot, last_texel, levels, sample};

use crate::color::Rgb;
use crate::hit::Surface;
use crate::math::Scalar;

/// Is the colour of a surface, linear light reflected of white light.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Texture<S = f32> {
    /// The same colour everywhere.
    Solid(Rgb<S>),
    /// A chessboard over the shape's texture coordinates.
    Checker(Checker<S>),
    /// A colour for each corner of a triangle.
    Vertices(Vertices<S>),
    /// Stripes over the shape's texture coordinates.
    Stripes(Stripes<S>),
    /// Rings over the shape's texture coordinates.
    Rings(Rings<S>),
    /// An image over the shape's texture coordinates.
    Image(Image<S>),
    /// The user's own.
    Custom(Procedural<S>),
}

impl<S: Scalar> Texture<S> {
    /// Answers the colour at a hit.
    pub fn color(&self, surface: &Surface<S>) -> Rgb<S> {
        match self {
            Self::Solid(color) => *color,
            Self::Checker(checker) => checker.color(surface.u, surface.v),
            Self::Vertices(vertices) => vertices.color(surface.u, surface.v),
            Self::Stripes(stripes) => stripes.color(surface.u, surface.v),
            Self::Rings(rings) => rings.color(surface.u, surface.v),
            Self::Image(image) => image.color(surface.u, surface.v),
            // A copy: what has its address handed out stays in memory for every texture.
            Self::Custom(procedural) => procedural.color(&{ *surface }),
        }
    }

    /// Answers a number of the tile at a hit: neighbouring tiles have different ones.
    ///
    /// Of the user's own nothing is known: each colour counts as a tile.
    pub fn tile(&self, surface: &Surface<S>) -> u32 {
        match self {
            Self::Solid(_) | Self::Vertices(_) => 0,
            Self::Checker(checker) => checker.tile(surface.u, surface.v),
            Self::Stripes(stripes) => stripes.tile(surface.u, surface.v),
            Self::Rings(rings) => rings.tile(surface.u, surface.v),
            Self::Image(image) => image.tile(surface.u, surface.v),
            Self::Custom(procedural) => {
                let Rgb { r, g, b } = procedural.color(&{ *surface });
                r.light_bits() ^ g.light_bits().rotate_left(11) ^ b.light_bits().rotate_left(22)
            }
        }
    }

    /// Tells whether the colour changes with the place.
    pub fn is_varied(&self) -> bool {
        !matches!(self, Self::Solid(_))
    }

    /// Tells whether every value is one a scene may contain.
    pub fn in_range(&self) -> bool {
        match self {
            Self::Solid(color) => color.in_range(),
            Self::Checker(checker) => checker.in_range(),
            Self::Vertices(vertices) => vertices.in_range(),
            Self::Stripes(stripes) => stripes.in_range(),
            Self::Rings(rings) => rings.in_range(),
            Self::Image(image) => image.in_range(),
            Self::Custom(_) => true,
        }
    }

    /// Answers the image it shows, if it shows one.
    pub fn image(&self) -> Option<&Image<S>> {
        if let Self::Image(image) = self { Some(image) } else { None }
    }
}
