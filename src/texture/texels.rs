use core::fmt;
use embedded_graphics_core::geometry::{OriginDimensions, Point};
use embedded_graphics_core::image::GetPixel;
use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

/// Is an image as a texture reads it: any image of `embedded-graphics` is one, in any colour.
///
/// `ImageRaw` reads its pixels from flash; a user's own type may as well compute them.
pub trait Texels: Sync {
    /// Answers the columns and rows.
    fn size(&self) -> [u32; 2];

    /// Answers red, green and blue of a texel as levels of 8 bits, row 0 at the top; any colour outside
    /// the image.
    fn texel(&self, column: u32, row: u32) -> [u8; 3];
}

impl<I> Texels for I
where
    I: GetPixel<Color: Into<Rgb888>> + OriginDimensions + Sync,
{
    fn size(&self) -> [u32; 2] {
        let size = OriginDimensions::size(self);
        [size.width, size.height]
    }

    fn texel(&self, column: u32, row: u32) -> [u8; 3] {
        let pixel = self.pixel(Point::new(column as i32, row as i32));
        pixel.map_or([0; 3], |color| {
            let color: Rgb888 = color.into();
            [color.r(), color.g(), color.b()]
        })
    }
}

/// Names an image; two are equal if they are the same one, wherever its like may be.
#[derive(Clone, Copy)]
pub struct Bitmap(&'static dyn Texels);

impl Bitmap {
    /// Is the most columns or rows that fixed point can count.
    pub const LARGEST: u32 = 2048;

    /// Names an image.
    pub const fn new(texels: &'static dyn Texels) -> Self {
        Self(texels)
    }

    /// Answers the columns and rows.
    pub fn size(&self) -> [u32; 2] {
        self.0.size()
    }

    /// Answers red, green and blue of a texel as levels of 8 bits, row 0 at the top.
    pub fn texel(&self, [column, row]: [u32; 2]) -> [u8; 3] {
        self.0.texel(column, row)
    }

    /// Tells whether the image has texels, and no more to a side than [`Bitmap::LARGEST`].
    pub fn fits(&self) -> bool {
        self.size().iter().all(|side| (1..=Self::LARGEST).contains(side))
    }
}

impl PartialEq for Bitmap {
    fn eq(&self, other: &Self) -> bool {
        core::ptr::addr_eq(self.0, other.0)
    }
}

impl fmt::Debug for Bitmap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [columns, rows] = self.size();
        write!(f, "Bitmap({columns}x{rows} at {:p})", core::ptr::from_ref(self.0).cast::<()>())
    }
}
