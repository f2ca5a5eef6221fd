//! Output: from linear light to the panel's colours.
//!
//! Exposure, then 24-bit integers, then a transfer curve, then ordered dithering, then the bits.

mod dither;
mod encode;
mod transfer;

pub use dither::Dither;
pub use encode::{Encode, Quantizer};
pub use transfer::Transfer;
