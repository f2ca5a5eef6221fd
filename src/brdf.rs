//! Reflection models: how much of the light from one direction goes into another.

use crate::math::{Scalar, Vec3};

/// Answers Lambert's diffuse factor `n.l`, at least 0 (row L2).
pub fn lambert<S: Scalar>(normal: Vec3<S>, to_light: Vec3<S>) -> S {
    normal.dot(to_light).max(S::ZERO)
}

/// Answers Phong's specular factor `(r.v)^n` with `r = 2 (n.l) n - l`, at least 0 (row L3).
///
/// All vectors have unit length and point away from the surface.
pub fn phong<S: Scalar>(normal: Vec3<S>, to_light: Vec3<S>, to_eye: Vec3<S>, shininess: u16) -> S {
    let mirrored = (-to_light).reflect(normal);
    let cosine = mirrored.dot(to_eye);
    if cosine > S::ZERO { cosine.pow_unit(shininess) } else { S::ZERO }
}
