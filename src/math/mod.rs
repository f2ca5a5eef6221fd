//! Numbers and vectors: one small trait, three numbers, no feature flags.
//!
//! Every formula of the crate is written once, over [`Scalar`]. `f32` serves chips with a
//! floating-point unit, [`Fixed`] those without, `f64` measures what the other two round away.

mod angle;
mod float;

mod double;
mod fixed;
mod reciprocal;
mod root;
mod scalar;
mod vec3;

pub use angle::tan_half;
pub use fixed::{Fixed, FixedWide};
pub use scalar::{Scalar, Wide};
pub use vec3::{Vec3, WideVec3};
