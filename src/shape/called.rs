//! Vector arithmetic that is called instead of inlined. Few scenes have the shapes that use it, but
//! every image carries them: in fixed point this takes 5 KB off a Cortex-M3's flash.

use crate::math::{Scalar, Vec3};

/// Answers [`Vec3::dot`].
#[inline(never)]
pub(super) fn dot<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> S {
    a.dot(b)
}

/// Answers [`Vec3::add_scaled`].
#[inline(never)]
pub(super) fn add_scaled<S: Scalar>(a: Vec3<S>, b: Vec3<S>, by: S) -> Vec3<S> {
    a.add_scaled(b, by)
}

/// Answers [`Vec3::add_scaled`], in fixed point rounded to the nearest step and not down.
#[inline(never)]
pub(super) fn add_scaled_nearest<S: Scalar>(a: Vec3<S>, b: Vec3<S>, by: S) -> Vec3<S> {
    let add = |a: S, b: S| S::determinant([a, by], [-b, S::ONE]);
    Vec3::new(add(a.x, b.x), add(a.y, b.y), add(a.z, b.z))
}

/// Answers [`Vec3::length`].
#[inline(never)]
pub(super) fn length<S: Scalar>(a: Vec3<S>) -> S {
    a.length()
}

/// Answers `a b`.
#[inline(never)]
pub(super) fn scaled<S: Scalar>(a: Vec3<S>, by: S) -> Vec3<S> {
    a * by
}

/// Answers `a - b`.
#[inline(never)]
pub(super) fn difference<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> Vec3<S> {
    a - b
}

/// Answers `a b`, wide.
#[inline(never)]
pub(super) fn product<S: Scalar>(a: S, b: S) -> S::Wide {
    a.mul_wide(b)
}

/// Answers `a b`, in fixed point rounded to the nearest step and not down.
#[inline(never)]
pub(super) fn product_nearest<S: Scalar>(a: S, b: S) -> S {
    S::narrow(a.mul_wide(b))
}

/// Answers the unit vector of the direction of another; `None` for zero.
#[inline(never)]
pub(super) fn normalized<S: Scalar>(a: Vec3<S>) -> Option<(Vec3<S>, S)> {
    a.normalize()
}
