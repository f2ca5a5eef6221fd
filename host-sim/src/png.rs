//! Pictures as PNG files.

use crate::image_error::into_io;
use crate::shot::Picture;
use image::{ExtendedColorType, ImageFormat};
use std::io;
use std::path::Path;

/// Writes a picture as a PNG file of 8 bits a channel, whatever the name ends in.
///
/// # Errors
/// What the file system says.
pub fn write(path: &Path, picture: &Picture) -> io::Result<()> {
    let [columns, rows] = picture.size;
    let bytes = picture.pixels.as_flattened();
    image::save_buffer_with_format(path, bytes, columns, rows, ExtendedColorType::Rgb8, ImageFormat::Png)
        .map_err(into_io)
}
