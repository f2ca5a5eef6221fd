use super::{Dither, Transfer};
use crate::color::Rgb;
use crate::math::Scalar;
use embedded_graphics_core::pixelcolor::{
    BinaryColor, Gray4, Gray8, IntoStorage, Rgb565, Rgb666, Rgb888, RgbColor,
};

/// Turns the light of one pixel into levels.
#[derive(Clone, Copy, Debug)]
pub struct Quantizer {
    transfer: Transfer,
    threshold: u32,
}

impl Quantizer {
    /// Makes the quantizer of the pixel in column `x` of row `y`.
    pub fn new(transfer: Transfer, dither: Dither, x: u32, y: u32) -> Self {
        Self { transfer, threshold: dither.threshold(x, y) }
    }

    /// Makes the quantizer of a pixel of its threshold, a fraction of 2^16.
    pub fn of_threshold(transfer: Transfer, threshold: u16) -> Self {
        Self { transfer, threshold: u32::from(threshold) }
    }
}

/// Rounds a level, a fraction of 2^16, to one of 0 to `top`.
fn quantize(level: u32, top: u8, threshold: u32) -> u8 {
    // A level is at most 2^16 and the threshold below it, so the largest level yields `top` itself.
    (level.wrapping_mul(u32::from(top)).wrapping_add(threshold) >> 16) as u8
}

/// Is a colour a panel understands.
pub trait Encode: Copy {
    /// Is the darkest colour.
    const DARKEST: Self;

    /// Lists the highest level of each channel; 0 for one that the panel does not have.
    const TOPS: [u8; 3];

    /// Answers what the panel's channels show of three 24-bit lights (red, green, blue), as fractions of
    /// 2^16; a channel that the panel does not have is 0.
    ///
    /// Colours between two are best found here, after the transfer curve: the eye sees equal steps.
    fn levels(light: [u32; 3], transfer: Transfer) -> [u32; 3];

    /// Rounds levels to a colour; the thresholds, fractions of 2^16 below 1, are added before rounding down.
    fn by_thresholds(levels: [u32; 3], thresholds: [u32; 3]) -> Self;

    /// Rounds levels to a colour by the same threshold.
    fn from_levels(levels: [u32; 3], threshold: u32) -> Self {
        Self::by_thresholds(levels, [threshold; 3])
    }

    /// Makes the colour of three 24-bit lights: red, green, blue.
    fn encode(light: [u32; 3], quantizer: Quantizer) -> Self {
        Self::from_levels(Self::levels(light, quantizer.transfer), quantizer.threshold)
    }

    /// Makes the colour of linear light.
    fn from_light<S: Scalar>(light: Rgb<S>, quantizer: Quantizer) -> Self {
        Self::encode(light_bits(light), quantizer)
    }
}

/// Answers red, green and blue as 24-bit lights.
pub(crate) fn light_bits<S: Scalar>(light: Rgb<S>) -> [u32; 3] {
    [light.r.light_bits(), light.g.light_bits(), light.b.light_bits()]
}

/// Answers the luminance of three 24-bit lights (Rec. 709 weights 0.2126, 0.7152, 0.0722).
fn luminance([r, g, b]: [u32; 3]) -> u32 {
    // The weights add up to 2^12 and the lights are cut to 2^19, so that white fits 32 bits.
    let [r, g, b] = [r, g, b].map(|light| light.min(1 << 24));
    ((r >> 5) * 871 + (g >> 5) * 2929 + (b >> 5) * 296) >> 7
}

/// Answers the levels of a panel that has greys only: luminance is a sum of lights, not of levels.
fn gray(light: [u32; 3], transfer: Transfer) -> [u32; 3] {
    [transfer.level(luminance(light)), 0, 0]
}

macro_rules! encode_rgb {
    ($color:ty, $red:expr, $green:expr, $blue:expr) => {
        impl Encode for $color {
            const DARKEST: Self = <$color>::new(0, 0, 0);
            const TOPS: [u8; 3] = [$red, $green, $blue];

            fn levels(light: [u32; 3], transfer: Transfer) -> [u32; 3] {
                light.map(|light| transfer.level(light))
            }

            fn by_thresholds([r, g, b]: [u32; 3], [red, green, blue]: [u32; 3]) -> Self {
                <$color>::new(quantize(r, $red, red), quantize(g, $green, green), quantize(b, $blue, blue))
            }

            /// Finishes a channel before the next is begun: three at once take ten instructions more.
            fn encode([r, g, b]: [u32; 3], Quantizer { transfer, threshold }: Quantizer) -> Self {
                let level = |light, top| quantize(transfer.level(light), top, threshold);
                <$color>::new(level(r, $red), level(g, $green), level(b, $blue))
            }
        }
    };
}

encode_rgb!(Rgb565, Rgb565::MAX_R, Rgb565::MAX_G, Rgb565::MAX_B);
encode_rgb!(Rgb666, Rgb666::MAX_R, Rgb666::MAX_G, Rgb666::MAX_B);
encode_rgb!(Rgb888, Rgb888::MAX_R, Rgb888::MAX_G, Rgb888::MAX_B);

impl Encode for Gray8 {
    const DARKEST: Self = Gray8::new(0);
    const TOPS: [u8; 3] = [255, 0, 0];

    fn levels(light: [u32; 3], transfer: Transfer) -> [u32; 3] {
        gray(light, transfer)
    }

    fn by_thresholds([gray, ..]: [u32; 3], [threshold, ..]: [u32; 3]) -> Self {
        Gray8::new(quantize(gray, 255, threshold))
    }
}

impl Encode for Gray4 {
    const DARKEST: Self = Gray4::new(0);
    const TOPS: [u8; 3] = [15, 0, 0];

    fn levels(light: [u32; 3], transfer: Transfer) -> [u32; 3] {
        gray(light, transfer)
    }

    fn by_thresholds([gray, ..]: [u32; 3], [threshold, ..]: [u32; 3]) -> Self {
        Gray4::new(quantize(gray, 15, threshold))
    }
}

impl Encode for BinaryColor {
    const DARKEST: Self = BinaryColor::Off;
    const TOPS: [u8; 3] = [1, 0, 0];

    fn levels(light: [u32; 3], transfer: Transfer) -> [u32; 3] {
        gray(light, transfer)
    }

    fn by_thresholds([gray, ..]: [u32; 3], [threshold, ..]: [u32; 3]) -> Self {
        if quantize(gray, 1, threshold) == 1 { BinaryColor::On } else { BinaryColor::Off }
    }
}

/// Is an [`Rgb565`] as most panels take it over the bus: the high byte first.
impl Encode for [u8; 2] {
    const DARKEST: Self = [0, 0];
    const TOPS: [u8; 3] = Rgb565::TOPS;

    fn levels(light: [u32; 3], transfer: Transfer) -> [u32; 3] {
        Rgb565::levels(light, transfer)
    }

    fn by_thresholds(levels: [u32; 3], thresholds: [u32; 3]) -> Self {
        Rgb565::by_thresholds(levels, thresholds).into_storage().to_be_bytes()
    }

    fn encode(light: [u32; 3], quantizer: Quantizer) -> Self {
        Rgb565::encode(light, quantizer).into_storage().to_be_bytes()
    }
}
