//! The images of the gallery, in flash. `cargo run -p host-sim --example images` computes them.

use crate::texture::Bitmap;
use core::marker::PhantomData;
use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
use embedded_graphics_core::image::GetPixel;
use embedded_graphics_core::pixelcolor::raw::RawData;
use embedded_graphics_core::pixelcolor::{Gray8, PixelColor, Rgb565, Rgb888};

/// Is raw pixels of whole bytes, the high byte first, row by row from the top.
struct Raw<C> {
    size: Size,
    bytes: &'static [u8],
    color: PhantomData<fn() -> C>,
}

impl<C> Raw<C> {
    const fn new(columns: u32, rows: u32, bytes: &'static [u8]) -> Self {
        Self { size: Size::new(columns, rows), bytes, color: PhantomData }
    }
}

impl<C> OriginDimensions for Raw<C> {
    fn size(&self) -> Size {
        self.size
    }
}

impl<C: PixelColor + From<C::Raw>> GetPixel for Raw<C> {
    type Color = C;

    fn pixel(&self, place: Point) -> Option<C> {
        let (column, row) = (u32::try_from(place.x).ok()?, u32::try_from(place.y).ok()?);
        let index = row.checked_mul(self.size.width)?.checked_add(column)? as usize;
        let length = C::Raw::BITS_PER_PIXEL / 8;
        let start = index.checked_mul(length)?;
        let bytes = self.bytes.get(start..start.checked_add(length)?)?;
        let value = bytes.iter().fold(0, |value, byte| value << 8 | u32::from(*byte));
        Some(C::from(C::Raw::from_u32(value)))
    }
}

/// Includes an image, under a name.
macro_rules! image {
    ($name:ident: $color:ty, $columns:literal x $rows:literal, $file:literal) => {
        pub(super) const $name: Bitmap = {
            static RAW: Raw<$color> = Raw::new($columns, $rows, include_bytes!(concat!("images/", $file)));
            Bitmap::new(&RAW)
        };
    };
}

image!(LETTERS: Rgb565, 32 x 32, "letters_32x32.rgb565");
image!(PAVEMENT: Rgb565, 8 x 8, "pavement_8x8.rgb565");
image!(WORLD: Rgb565, 96 x 48, "world_96x48.rgb565");
image!(CRATERS: Gray8, 96 x 48, "craters_96x48.gray8");
image!(PEEL: Gray8, 32 x 32, "peel_32x32.gray8");
image!(DIMPLES: Rgb888, 16 x 16, "dimples_16x16.rgb888");

/// Is a dusk over a lake, toward low x, high x, low y, high y, low z and high z.
pub(super) static DUSK: [Bitmap; 6] =
    [DUSK_LOW_X, DUSK_HIGH_X, DUSK_LOW_Y, DUSK_HIGH_Y, DUSK_LOW_Z, DUSK_HIGH_Z];
image!(DUSK_LOW_X: Rgb565, 32 x 32, "dusk_low_x_32x32.rgb565");
image!(DUSK_HIGH_X: Rgb565, 32 x 32, "dusk_high_x_32x32.rgb565");
image!(DUSK_LOW_Y: Rgb565, 32 x 32, "dusk_low_y_32x32.rgb565");
image!(DUSK_HIGH_Y: Rgb565, 32 x 32, "dusk_high_y_32x32.rgb565");
image!(DUSK_LOW_Z: Rgb565, 32 x 32, "dusk_low_z_32x32.rgb565");
image!(DUSK_HIGH_Z: Rgb565, 32 x 32, "dusk_high_z_32x32.rgb565");
