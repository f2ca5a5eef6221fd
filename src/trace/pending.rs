use super::departure::Departure;
use crate::color::Rgb;
use crate::math::{Scalar, Vec3};
use crate::ray::Ray;

/// Stands for the space around all glass, in place of the glass's material.
pub(super) const SPACE: u16 = u16::MAX;

/// Is a ray that waits while the tree of its sibling is followed.
#[derive(Clone, Copy, Debug)]
pub struct Pending<S: Scalar> {
    pub(super) ray: Ray<S>,
    pub(super) weight: Rgb<S>,
    pub(super) from: Departure,
    /// Material of the glass it goes through.
    pub(super) within: u16,
    pub(super) level: u8,
}

impl<S: Scalar> Pending<S> {
    /// Is a place for a ray.
    pub const NONE: Self = Self {
        ray: Ray::new(Vec3::ZERO, Vec3::ZERO),
        weight: Rgb::BLACK,
        from: Departure::UNSET,
        within: 0,
        level: 0,
    };
}
