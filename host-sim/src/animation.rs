//! Animated GIF files.

use crate::shot::Picture;
use gif::{Encoder, EncodingError, Frame, Repeat};
use std::io::{self, Write};
use std::ops::Range;

/// Is how carefully the 256 colours of a frame are chosen: 1 is best, 30 is fastest.
const HASTE: i32 = 10;

/// Is an animation that begins again when it is over.
pub struct Animation<W: Write>(Encoder<W>);

impl<W: Write> Animation<W> {
    /// Begins an animation of so many columns and rows.
    ///
    /// # Errors
    /// What the writer says; a side beyond 65535 pixels.
    pub fn new(writer: W, size: [u32; 2]) -> io::Result<Self> {
        let mut encoder = Encoder::new(writer, short(size[0])?, short(size[1])?, &[]).map_err(into_io)?;
        encoder.set_repeat(Repeat::Infinite).map_err(into_io)?;
        Ok(Self(encoder))
    }

    /// Shows some rows of a picture as wide as the animation over what is shown already, for so many
    /// hundredths of a second.
    ///
    /// # Errors
    /// What the writer says; rows that the picture does not have.
    pub fn show(&mut self, picture: &Picture, rows: Range<u32>, hundredths: u16) -> io::Result<()> {
        let columns = picture.size[0];
        let part = picture.pixels.get((rows.start * columns) as usize..(rows.end * columns) as usize);
        let part = part.ok_or_else(|| io::Error::other("the picture has no such rows"))?;
        let (width, height) = (short(columns)?, short(rows.len() as u32)?);
        let mut frame = Frame::from_rgb_speed(width, height, part.as_flattened(), HASTE);
        (frame.top, frame.delay) = (short(rows.start)?, hundredths);
        self.0.write_frame(&frame).map_err(into_io)
    }
}

fn short(side: u32) -> io::Result<u16> {
    u16::try_from(side).map_err(io::Error::other)
}

fn into_io(error: EncodingError) -> io::Error {
    match error {
        EncodingError::Io(error) => error,
        other => io::Error::other(other),
    }
}
