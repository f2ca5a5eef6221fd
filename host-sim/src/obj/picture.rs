//! Images that materials name: PNG files.

use super::wrong::{Mistake, Reason};
use image::{ImageError, ImageFormat, ImageReader, Limits};
use scanray::{Bitmap, Texels};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Is the levels of an image, row by row from the top.
struct Levels {
    size: [u32; 2],
    texels: Vec<[u8; 3]>,
}

impl Texels for Levels {
    fn size(&self) -> [u32; 2] {
        self.size
    }

    fn texel(&self, column: u32, row: u32) -> [u8; 3] {
        let place = row as usize * self.size[0] as usize + column as usize;
        self.texels.get(place).copied().unwrap_or_default()
    }
}

/// Reads a file of at most [`Bitmap::LARGEST`] texels to a side; it stays in memory as long as the program runs.
///
/// # Errors
/// A file that cannot be read, or is no PNG file, or too large.
pub fn read(path: &Path) -> Result<Bitmap, Mistake> {
    let file = File::open(path).map_err(|error| Reason::Io(error).of(path))?;
    let mut reader = ImageReader::with_format(BufReader::new(file), ImageFormat::Png);
    let mut limits = Limits::default();
    limits.max_image_width = Some(Bitmap::LARGEST);
    limits.max_image_height = Some(Bitmap::LARGEST);
    reader.limits(limits);
    let picture = reader.decode().map_err(|error| reason(error).of(path))?.into_rgb8();
    let (columns, rows) = picture.dimensions();
    let levels = Levels { size: [columns, rows], texels: picture.pixels().map(|pixel| pixel.0).collect() };
    Ok(Bitmap::new(Box::leak(Box::new(levels))))
}

fn reason(error: ImageError) -> Reason {
    match error {
        ImageError::IoError(error) => Reason::Io(error),
        ImageError::Limits(_) => Reason::ImageSize(Bitmap::LARGEST),
        other => Reason::Image(other),
    }
}
