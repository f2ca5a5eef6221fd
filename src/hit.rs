//! What a ray finds: a crossing for all, a surface for the nearest.

use crate::math::{Scalar, Vec3};

/// Is where a ray crosses a shape, as little as the search for the nearest needs.
///
/// The full [`Surface`] is worked out for the winner only (the two phases of pbrt).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<S = f32> {
    /// Distance along the ray.
    pub t: S,
    /// Which part of the shape was hit: a face of a cuboid, else 0.
    pub part: u16,
    /// First coordinate on the part, where finding the crossing yields it.
    pub u: S,
    /// Second coordinate on the part, where finding the crossing yields it.
    pub v: S,
}

impl<S: Scalar> Crossing<S> {
    /// Makes a crossing of a shape that has one part and no coordinates yet.
    pub const fn at(t: S) -> Self {
        Self { t, part: 0, u: S::ZERO, v: S::ZERO }
    }
}

/// Is the surface at a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<S = f32> {
    /// Point in world space, moved onto the surface as closely as the number allows.
    pub point: Vec3<S>,
    /// Outward normal of unit length.
    pub normal: Vec3<S>,
    /// First texture coordinate, in the shape's own measure.
    pub u: S,
    /// Second texture coordinate, in the shape's own measure.
    pub v: S,
    /// Which part of the shape it is.
    pub part: u16,
}

/// Is the way along which a texture coordinate grows over a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tangent<S = f32> {
    /// Unit vector along the surface; the other coordinate stays.
    pub direction: Vec3<S>,
    /// Length of surface to a unit of the coordinate.
    pub length: S,
}

impl<S: Scalar> Tangent<S> {
    /// Makes a tangent of the derivative of the point by the coordinate.
    pub fn along(derivative: Vec3<S>) -> Self {
        let (direction, length) = derivative.normalize().unwrap_or((Vec3::ZERO, S::ZERO));
        Self { direction, length }
    }
}
