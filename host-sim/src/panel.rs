//! Panels: the colour formats of displays, and what their pixels look like.

use embedded_graphics_core::pixelcolor::{
    BinaryColor, Gray4, Gray8, GrayColor, PixelColor, Rgb565, Rgb666, Rgb888, RgbColor,
};
use scanray::math::Scalar;
use scanray::output::Quantizer;
use scanray::{Dither, Encode, Rgb, Transfer};

/// Names the colour format of a display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Panel {
    /// 5, 6 and 5 bits.
    Rgb565,
    /// 6 bits a channel.
    Rgb666,
    /// 8 bits a channel.
    Rgb888,
    /// 256 greys.
    Gray8,
    /// 16 greys.
    Gray4,
    /// Black and white.
    Mono,
}

/// Spreads a level of 0 to `top` over 8 bits, rounded.
fn spread(level: u8, top: u8) -> u8 {
    ((u32::from(level) * 255 + u32::from(top) / 2) / u32::from(top)) as u8
}

fn rgb<C: RgbColor>(color: C) -> [u8; 3] {
    [spread(color.r(), C::MAX_R), spread(color.g(), C::MAX_G), spread(color.b(), C::MAX_B)]
}

/// Is a pixel before it is rounded for its panel, so that one renderer serves all panels of colours and
/// one all panels of greys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unrounded<const GRAY: bool> {
    levels: [u32; 3],
    threshold: u32,
}

impl<const GRAY: bool> PixelColor for Unrounded<GRAY> {
    type Raw = ();
}

impl<const GRAY: bool> Encode for Unrounded<GRAY> {
    const DARKEST: Self = Self { levels: [0; 3], threshold: 0 };

    fn levels(light: [u32; 3], transfer: Transfer) -> [u32; 3] {
        if GRAY { Gray8::levels(light, transfer) } else { Rgb888::levels(light, transfer) }
    }

    fn from_levels(levels: [u32; 3], threshold: u32) -> Self {
        Self { levels, threshold }
    }
}

impl Panel {
    /// Lists all panels.
    pub const ALL: [Self; 6] =
        [Self::Rgb565, Self::Rgb666, Self::Rgb888, Self::Gray8, Self::Gray4, Self::Mono];

    /// Answers the name, as commands take it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rgb565 => "rgb565",
            Self::Rgb666 => "rgb666",
            Self::Rgb888 => "rgb888",
            Self::Gray8 => "gray8",
            Self::Gray4 => "gray4",
            Self::Mono => "mono",
        }
    }

    /// Encodes light for the panel with the core's own encoder and answers what it looks like.
    pub fn show<S: Scalar>(
        self,
        light: Rgb<S>,
        transfer: Transfer,
        dither: Dither,
        x: u32,
        y: u32,
    ) -> [u8; 3] {
        let quantizer = Quantizer::new(transfer, dither, x, y);
        match self {
            Self::Rgb565 | Self::Rgb666 | Self::Rgb888 => {
                self.round(Unrounded::<false>::from_light(light, quantizer))
            }
            Self::Gray8 | Self::Gray4 | Self::Mono => {
                self.round(Unrounded::<true>::from_light(light, quantizer))
            }
        }
    }

    /// Rounds a pixel with the core's own encoder and answers what it looks like.
    pub fn round<const GRAY: bool>(self, pixel: Unrounded<GRAY>) -> [u8; 3] {
        let Unrounded { levels, threshold } = pixel;
        match self {
            Self::Rgb565 => rgb(Rgb565::from_levels(levels, threshold)),
            Self::Rgb666 => rgb(Rgb666::from_levels(levels, threshold)),
            Self::Rgb888 => rgb(Rgb888::from_levels(levels, threshold)),
            Self::Gray8 => [Gray8::from_levels(levels, threshold).luma(); 3],
            Self::Gray4 => [spread(Gray4::from_levels(levels, threshold).luma(), 15); 3],
            Self::Mono => [spread(BinaryColor::from_levels(levels, threshold).is_on() as u8, 1); 3],
        }
    }
}
