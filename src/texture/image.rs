use super::srgb;
use super::texels::Bitmap;
use crate::color::Rgb;
use crate::math::Scalar;

/// Names how the colour between texels is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Filter {
    /// The colour of the nearest texel.
    Nearest,
    /// The colours of the four texels around, mixed by the distances in linear light.
    #[default]
    Bilinear,
}

/// Is an image over a shape's texture coordinates (row T1).
///
/// Coordinate u runs from the middles of the leftmost texels, at 0, to those of the rightmost, at 1,
/// and v from the bottom row up: column `j = u (w - 1)`, row `i = v (h - 1)` from below. Beyond that
/// the image is repeated. Levels count as sRGB and are decoded to linear light before they are mixed.
///
/// ```
/// use embedded_graphics::image::ImageRaw;
/// use embedded_graphics::pixelcolor::Rgb565;
/// use scanray::{Bitmap, Image, Material, Texture};
///
/// static FLAG: ImageRaw<Rgb565> = ImageRaw::new(&[0xf8, 0x00, 0xff, 0xff, 0x00, 0x1f], 3);
/// static CLOTH: [Material; 1] = [Material::textured(Texture::Image(Image::new(Bitmap::new(&FLAG))))];
/// assert_eq!(CLOTH[0].check(), Ok(()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Image<S = f32> {
    /// The texels.
    pub bitmap: Bitmap,
    /// How often the image is repeated over a unit of u and of v; below 0 it is mirrored.
    pub per_unit: [S; 2],
    /// How the colour between texels is found.
    pub filter: Filter,
}

/// Is a place in an image, in texels from the upper left one's middle, and the copy it lies in.
pub(crate) struct Spot<S> {
    pub right: S,
    pub down: S,
    copy: [i32; 2],
}

impl<S: Scalar> Image<S> {
    /// Makes a texture of an image, once over the unit square, smoothed.
    pub const fn new(bitmap: Bitmap) -> Self {
        Self { bitmap, per_unit: [S::ONE; 2], filter: Filter::Bilinear }
    }

    /// Sets how often the image is repeated over a unit of u and of v; below 0 it is mirrored.
    pub const fn with_tiles(mut self, u: S, v: S) -> Self {
        self.per_unit = [u, v];
        self
    }

    /// Sets how the colour between texels is found.
    pub const fn with_filter(mut self, filter: Filter) -> Self {
        self.filter = filter;
        self
    }

    /// Answers the colour at texture coordinates, linear light.
    #[inline(never)]
    pub fn color(&self, u: S, v: S) -> Rgb<S> {
        if cfg!(feature = "images") {
            sample(&self.bitmap, self.filter, &self.spot(u, v))
        } else {
            Rgb::BLACK
        }
    }

    /// Answers a number of the texels that the colour at texture coordinates comes from, other for
    /// neighbouring ones and in each copy.
    #[inline(never)]
    pub fn tile(&self, u: S, v: S) -> u32 {
        if !cfg!(feature = "images") {
            return 0;
        }
        let spot = self.spot(u, v);
        let [column, row] = cell(self.filter, &spot);
        let [i, j] = spot.copy.map(|copy| (copy as u32).wrapping_mul(Bitmap::LARGEST));
        i.wrapping_add(column) ^ j.wrapping_add(row).rotate_left(16)
    }

    /// Answers the place in the image that lies at texture coordinates.
    pub(crate) fn spot(&self, u: S, v: S) -> Spot<S> {
        let [right, up] = last_texel(&self.bitmap);
        let [across, along] = [u.mul_wide(self.per_unit[0]), v.mul_wide(self.per_unit[1])];
        Spot {
            right: S::fract(across) * right,
            down: (S::ONE - S::fract(along)) * up,
            copy: [S::floor(across), S::floor(along)],
        }
    }

    /// Tells whether every value is one a scene may contain.
    pub fn in_range(&self) -> bool {
        self.per_unit.iter().all(|count| count.in_range())
    }
}

/// Answers the column of the rightmost texel and the row of the lowest.
pub(crate) fn last_texel<S: Scalar>(bitmap: &Bitmap) -> [S; 2] {
    bitmap.size().map(|side| S::from_i32(side.saturating_sub(1) as i32))
}

fn floor<S: Scalar>(value: S) -> u32 {
    S::floor(value.mul_wide(S::ONE)) as u32
}

/// Answers the upper left one of the texels a colour comes from.
fn cell<S: Scalar>(filter: Filter, spot: &Spot<S>) -> [u32; 2] {
    match filter {
        Filter::Nearest => [floor(spot.right + S::HALF), floor(spot.down + S::HALF)],
        Filter::Bilinear => [floor(spot.right), floor(spot.down)],
    }
}

/// Answers the linear light of an image in a place.
pub(crate) fn sample<S: Scalar>(bitmap: &Bitmap, filter: Filter, spot: &Spot<S>) -> Rgb<S> {
    match filter {
        Filter::Nearest => srgb::decode(bitmap.texel(cell(filter, spot))),
        Filter::Bilinear => mix(bitmap, spot, srgb::decode),
    }
}

/// Answers the levels of an image in a place, 0 to 255, mixed of the four texels around.
#[inline(never)]
pub(crate) fn levels<S: Scalar>(bitmap: &Bitmap, spot: &Spot<S>) -> Rgb<S> {
    mix(bitmap, spot, |[r, g, b]| {
        let level = |level: u8| S::from_i32(i32::from(level));
        Rgb::new(level(r), level(g), level(b))
    })
}

fn mix<S: Scalar>(bitmap: &Bitmap, spot: &Spot<S>, read: impl Fn([u8; 3]) -> Rgb<S>) -> Rgb<S> {
    let [column, row] = cell(Filter::Bilinear, spot);
    let [columns, rows] = bitmap.size();
    let texel = |column: u32, row: u32| {
        read(bitmap.texel([column.min(columns.saturating_sub(1)), row.min(rows.saturating_sub(1))]))
    };
    let right = S::fract(spot.right.mul_wide(S::ONE));
    let down = S::fract(spot.down.mul_wide(S::ONE));
    let line = |row| lerp(texel(column, row), texel(column.wrapping_add(1), row), right);
    lerp(line(row), line(row.wrapping_add(1)), down)
}

/// Answers the colour at a share of the way from one to another.
fn lerp<S: Scalar>(from: Rgb<S>, to: Rgb<S>, share: S) -> Rgb<S> {
    let between = |a: S, b: S| a.add_product(b - a, share);
    Rgb::new(between(from.r, to.r), between(from.g, to.g), between(from.b, to.b))
}

impl<S: Scalar> Spot<S> {
    /// Makes a place of the distances from the upper left texel's middle.
    pub fn at(right: S, down: S) -> Self {
        Self { right, down, copy: [0; 2] }
    }

    /// Answers a number of the texels that the colour here comes from.
    pub fn number(&self, filter: Filter) -> u32 {
        let [column, row] = cell(filter, self);
        column ^ row.rotate_left(16)
    }
}
