//! Output: from linear light to the panel's colours.
//!
//! Exposure, then 24-bit integers, then a transfer curve, then ordered dithering, then the bits.

mod dither;
mod encode;
mod transfer;

pub use dither::{Dither, Thresholds};
pub(crate) use encode::light_bits;
pub use encode::{Encode, Quantizer};
pub use transfer::Transfer;
