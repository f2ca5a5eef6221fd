//! Numbers and vectors: one small trait, three numbers, no feature flags.
//!
//! Every formula of the crate is written once, over [`Scalar`]. `f32` serves chips with a
//! floating-point unit, [`Fixed`] those without, `f64` measures what the other two round away.

mod angle;
mod azimuth;
mod float;

mod double;
mod fixed;
mod wide;

mod power;
mod product;
mod quotient;
mod reciprocal;
mod root;
mod seed;
mod steps;
mod unit;
mod zeros;

mod scalar;
mod units;
mod vec3;

pub use angle::{cosine, tan_half};
pub use azimuth::{Arctangent, turns};
pub use fixed::Fixed;
pub(crate) use reciprocal::rough_reciprocal;
pub use scalar::{Scalar, Wide};
pub use units::Units;
pub use vec3::{Vec3, WideVec3};
pub use wide::FixedWide;
