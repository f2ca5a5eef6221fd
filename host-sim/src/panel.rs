//! Panels: the colour formats of displays, and what their pixels look like.

use embedded_graphics_core::pixelcolor::{
    BinaryColor, Gray4, Gray8, GrayColor, PixelColor, Rgb565, Rgb666, Rgb888, RgbColor,
};
use scanray::math::Scalar;
use scanray::output::{Quantizer, Rounding};
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
    /// What the panel's channels show, as fractions of 2^16.
    pub levels: [u32; 3],
}

impl<const GRAY: bool> PixelColor for Unrounded<GRAY> {
    type Raw = ();
}

impl<const GRAY: bool> Encode for Unrounded<GRAY> {
    const DARKEST: Self = Self { levels: [0; 3] };
    /// Nothing is rounded, so that nothing is left to hand on.
    const TOPS: [u8; 3] = [0; 3];

    fn levels(light: [u32; 3], transfer: Transfer) -> [u32; 3] {
        if GRAY { Gray8::levels(light, transfer) } else { Rgb888::levels(light, transfer) }
    }

    fn by_thresholds(levels: [u32; 3], _: [u32; 3]) -> Self {
        Self { levels }
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

    /// Tells whether it shows greys only.
    pub fn is_gray(self) -> bool {
        matches!(self, Self::Gray8 | Self::Gray4 | Self::Mono)
    }

    /// Answers what the panel's channels are to show of light, as fractions of 2^16, by the core's own encoder.
    pub fn levels<S: Scalar>(self, light: Rgb<S>, transfer: Transfer) -> [u32; 3] {
        let unrounded = Quantizer::of_threshold(transfer, 0);
        if self.is_gray() {
            Unrounded::<true>::from_light(light, unrounded).levels
        } else {
            Unrounded::<false>::from_light(light, unrounded).levels
        }
    }

    /// Answers the highest levels of its channels: three, or one of greys.
    pub fn tops(self) -> &'static [u8] {
        match self {
            Self::Rgb565 => &Rgb565::TOPS,
            Self::Rgb666 => &Rgb666::TOPS,
            Self::Rgb888 => &Rgb888::TOPS,
            Self::Gray8 => &[255],
            Self::Gray4 => &[15],
            Self::Mono => &[1],
        }
    }

    /// Answers the levels that a pixel's 8 bits stand for, in steps of 8 bits, without what they round off.
    pub fn exactly(self, shown: [u8; 3]) -> [f64; 3] {
        let tops = self.tops();
        std::array::from_fn(|i| {
            let step = 255.0 / f64::from(tops[i % tops.len()]);
            (f64::from(shown[i]) / step).round() * step
        })
    }

    /// Rounds the levels of the pixel in column `x` with the core's own encoder and answers what it looks like.
    pub fn round_pixel(self, x: u32, levels: [u32; 3], rounding: &mut Rounding) -> [u8; 3] {
        match self {
            Self::Rgb565 => rgb::<Rgb565>(rounding.round(x, levels)),
            Self::Rgb666 => rgb::<Rgb666>(rounding.round(x, levels)),
            Self::Rgb888 => rgb::<Rgb888>(rounding.round(x, levels)),
            Self::Gray8 => [rounding.round::<Gray8>(x, levels).luma(); 3],
            Self::Gray4 => [spread(rounding.round::<Gray4>(x, levels).luma(), 15); 3],
            Self::Mono => [spread(rounding.round::<BinaryColor>(x, levels).is_on() as u8, 1); 3],
        }
    }

    /// Rounds the levels of row `y` and answers what it looks like.
    pub fn round_row(self, levels: impl Iterator<Item = [u32; 3]>, dither: Dither, y: u32) -> Vec<[u8; 3]> {
        let mut rounding = Rounding::of_row(dither, y);
        (0..).zip(levels).map(|(x, levels)| self.round_pixel(x, levels, &mut rounding)).collect()
    }

    /// Rounds the levels of a picture of so many columns and answers what it looks like.
    pub fn round(self, levels: &[[u32; 3]], columns: u32, dither: Dither) -> Vec<[u8; 3]> {
        let rows = (0..).zip(levels.chunks(columns.max(1) as usize));
        rows.flat_map(|(y, row)| self.round_row(row.iter().copied(), dither, y)).collect()
    }
}
