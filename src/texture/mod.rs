//! Textures: what colours a surface has from place to place.

mod checker;
mod vertices;

pub use checker::Checker;
pub use vertices::Vertices;

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
}

impl<S: Scalar> Texture<S> {
    /// Answers the colour at a hit.
    pub fn color(&self, surface: &Surface<S>) -> Rgb<S> {
        match self {
            Self::Solid(color) => *color,
            Self::Checker(checker) => checker.color(surface.u, surface.v),
            Self::Vertices(vertices) => vertices.color(surface.u, surface.v),
        }
    }

    /// Answers a number of the tile at a hit: neighbouring tiles have different ones.
    pub fn tile(&self, surface: &Surface<S>) -> u32 {
        match self {
            Self::Solid(_) | Self::Vertices(_) => 0,
            Self::Checker(checker) => checker.tile(surface.u, surface.v),
        }
    }

    /// Tells whether every value is one a scene may contain.
    pub fn in_range(&self) -> bool {
        match self {
            Self::Solid(color) => color.in_range(),
            Self::Checker(checker) => checker.in_range(),
            Self::Vertices(vertices) => vertices.in_range(),
        }
    }
}
