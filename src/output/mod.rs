//! Output: from linear light to the panel's colours.
//!
//! Exposure, then 24-bit integers, then a transfer curve, then dithering, then the bits.

mod blue_noise;
mod dither;
mod encode;
mod rounding;
mod transfer;

pub use blue_noise::BLUE_NOISE;
pub use dither::{Dither, Mask, Thresholds};
pub(crate) use encode::light_bits;
pub use encode::{Encode, Quantizer};
pub use rounding::Rounding;
pub use transfer::Transfer;
