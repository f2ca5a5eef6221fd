//! Panels: the colour formats of displays, and what their pixels look like.

use embedded_graphics_core::pixelcolor::{
    BinaryColor, Gray4, Gray8, GrayColor, Rgb565, Rgb666, Rgb888, RgbColor,
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

/// Is a panel's colour, which can be shown in 8 bits a channel.
pub trait Shown: Encode {
    /// Answers what it looks like.
    fn shown(self) -> [u8; 3];
}

macro_rules! shown {
    ($($color:ty: $self:ident => $shown:expr;)*) => {
        $(impl Shown for $color {
            fn shown($self) -> [u8; 3] {
                $shown
            }
        })*
    };
}

shown! {
    Rgb565: self => rgb(self);
    Rgb666: self => rgb(self);
    Rgb888: self => rgb(self);
    Gray8: self => [self.luma(); 3];
    Gray4: self => [spread(self.luma(), 15); 3];
    BinaryColor: self => [spread(self.is_on() as u8, 1); 3];
}

/// Calls the same function for whichever panel's colour it is.
macro_rules! in_color_of {
    ($panel:expr, $color:ident => $call:expr) => {{
        use embedded_graphics_core::pixelcolor as colors;
        use $crate::panel::Panel;
        match $panel {
            Panel::Rgb565 => in_color_of!(@ $color = colors::Rgb565, $call),
            Panel::Rgb666 => in_color_of!(@ $color = colors::Rgb666, $call),
            Panel::Rgb888 => in_color_of!(@ $color = colors::Rgb888, $call),
            Panel::Gray8 => in_color_of!(@ $color = colors::Gray8, $call),
            Panel::Gray4 => in_color_of!(@ $color = colors::Gray4, $call),
            Panel::Mono => in_color_of!(@ $color = colors::BinaryColor, $call),
        }
    }};
    (@ $color:ident = $type:ty, $call:expr) => {{
        type $color = $type;
        $call
    }};
}

pub(crate) use in_color_of;

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
        in_color_of!(self, Color => Color::from_light(light, quantizer).shown())
    }
}
