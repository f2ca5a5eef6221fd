use image::ImageError;
use std::io;

/// Answers what the file system says of an image that cannot be written.
pub(crate) fn into_io(error: ImageError) -> io::Error {
    match error {
        ImageError::IoError(error) => error,
        other => io::Error::other(other),
    }
}
