//! The images of a scene file, as PNG files.
//!
//! The core reads texels as levels of 8 bits whatever colours they are kept in, and these levels are what a
//! PNG file holds: grey ones if red, green and blue agree in every texel, else all three. Levels of fewer
//! bits, of `Rgb565` for one, are spread over 8 bits so that each comes back when it is rounded again.

use crate::files::Files;
use crate::image_error::into_io;
use image::codecs::png::PngDecoder;
use image::{ColorType, ExtendedColorType, ImageDecoder, ImageError, ImageFormat, Limits};
use scanray::{Bitmap, Texels};
use std::fmt;
use std::io::{self, BufRead, Seek};
use std::path::Path;

/// Is how many texels all images of a scene may have together: eight of the largest, 96 MiB.
pub const MAX_TEXELS: u32 = 8 * Bitmap::LARGEST * Bitmap::LARGEST;

/// Is how many bytes the decoder may take beside the texels.
const DECODER_BYTES: u64 = 1 << 26;

/// Tells why an image cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unreadable {
    /// There is no such file.
    Missing,
    /// It is a directory or a device.
    NotAFile,
    /// The system does not hand it out.
    Withheld(io::ErrorKind),
    /// It is no PNG, or a broken one: the decoder's words.
    Broken(String),
    /// Its pixels are of this kind.
    Pixels(ColorType),
    /// It is wider or higher than [`Bitmap::LARGEST`].
    TooLarge,
    /// With it the images of the scene have more than [`MAX_TEXELS`].
    TooMany,
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing => f.write_str("there is no such file"),
            Self::NotAFile => f.write_str("it is no file"),
            Self::Withheld(kind) => kind.fmt(f),
            Self::Broken(why) => write!(f, "it is no PNG, or a broken one: {why}"),
            Self::Pixels(kind) => write!(
                f,
                "its pixels are {kind:?}; those of an image are grey or red, green and blue, \
                 of at most 8 bits and without alpha"
            ),
            Self::TooLarge => write!(f, "it is more than {} texels wide or high", Bitmap::LARGEST),
            Self::TooMany => write!(f, "the images of a scene have at most {MAX_TEXELS} texels together"),
        }
    }
}

impl std::error::Error for Unreadable {}

/// Holds texels, row by row from the top.
struct Pixels {
    size: [u32; 2],
    levels: Vec<[u8; 3]>,
}

impl Texels for Pixels {
    fn size(&self) -> [u32; 2] {
        self.size
    }

    fn texel(&self, column: u32, row: u32) -> [u8; 3] {
        let index = row as usize * self.size[0] as usize + column as usize;
        self.levels.get(index).copied().unwrap_or_default()
    }
}

/// Is an image without texels, which the core refuses: it stands for one that has not been read.
pub(super) static UNREAD: &dyn Texels = &Pixels { size: [0, 0], levels: vec![] };

/// Reads an image of at most so many texels; it stays in memory as long as the program runs.
///
/// # Errors
/// What is wrong with it; of one that is too large no more than the header has been read.
pub fn read(files: &dyn Files, path: &Path, most_texels: u32) -> Result<Bitmap, Unreadable> {
    let open = files.open(path).map_err(withheld)?.ok_or(Unreadable::NotAFile)?;
    decode(open.content, most_texels)
}

/// Decodes an image as [`read`] does.
///
/// # Errors
/// As there.
pub fn decode(file: impl BufRead + Seek, most_texels: u32) -> Result<Bitmap, Unreadable> {
    let decoder = begin(file)?;
    let (columns, rows) = decoder.dimensions();
    if columns * rows > most_texels {
        return Err(Unreadable::TooMany);
    }
    let kind = decoder.color_type();
    let levels: fn(Vec<u8>) -> Vec<[u8; 3]> = match kind {
        ColorType::L8 => |bytes| bytes.into_iter().map(|grey| [grey; 3]).collect(),
        ColorType::Rgb8 => |bytes| bytes.as_chunks().0.to_vec(),
        other => return Err(Unreadable::Pixels(other)),
    };
    let mut bytes = vec![0; (columns * rows) as usize * usize::from(kind.bytes_per_pixel())];
    decoder.read_image(&mut bytes).map_err(broken)?;
    Ok(Bitmap::new(Box::leak(Box::new(Pixels { size: [columns, rows], levels: levels(bytes) }))))
}

/// Reads the header of an image of at most [`Bitmap::LARGEST`] columns and rows.
fn begin<R: BufRead + Seek>(file: R) -> Result<PngDecoder<R>, Unreadable> {
    let mut limits = Limits::default();
    limits.max_image_width = Some(Bitmap::LARGEST);
    limits.max_image_height = Some(Bitmap::LARGEST);
    limits.max_alloc = Some(DECODER_BYTES);
    PngDecoder::with_limits(file, limits).map_err(broken)
}

fn withheld(error: io::Error) -> Unreadable {
    match error.kind() {
        io::ErrorKind::NotFound => Unreadable::Missing,
        other => Unreadable::Withheld(other),
    }
}

fn broken(error: ImageError) -> Unreadable {
    use image::error::LimitErrorKind::DimensionError;
    match error {
        ImageError::Limits(limit) if limit.kind() == DimensionError => Unreadable::TooLarge,
        other => Unreadable::Broken(other.to_string()),
    }
}

/// Writes an image as a PNG file that is read back to the bit.
///
/// # Errors
/// What the file system says.
pub fn write(path: &Path, bitmap: &Bitmap) -> io::Result<()> {
    let [columns, rows] = bitmap.size();
    let row = |row| (0..columns).map(move |column| bitmap.texel([column, row]));
    let levels: Vec<[u8; 3]> = (0..rows).flat_map(row).collect();
    let is_grey = levels.iter().all(|[r, g, b]| r == g && g == b);
    let (bytes, kind) = if is_grey {
        (levels.iter().map(|[grey, ..]| *grey).collect(), ExtendedColorType::L8)
    } else {
        (levels.into_flattened(), ExtendedColorType::Rgb8)
    };
    image::save_buffer_with_format(path, &bytes, columns, rows, kind, ImageFormat::Png).map_err(into_io)
}
