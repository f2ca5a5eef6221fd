use crate::camera::CameraError;
use crate::scene::SceneError;
use core::fmt;

/// Tells why a picture cannot be begun.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RenderError {
    /// Something of the scene is wrong.
    Scene(SceneError),
    /// Something of the camera or the picture's size is wrong.
    Camera(CameraError),
    /// A row does not fit the workspace.
    RowTooWide {
        /// Pixels in a row of the picture.
        width: u32,
        /// Pixels the workspace has room for.
        room: usize,
    },
    /// The workspace has no room for so many bounces.
    TooDeep {
        /// Bounces asked for.
        depth: u8,
        /// Bounces the workspace has room for.
        room: usize,
    },
    /// The exposure is negative, not a number or too large for the number type.
    Exposure,
    /// A pixel is to take no samples, or too many.
    Samples {
        /// Samples asked for along a side of a pixel.
        side: u8,
        /// The most there may be.
        most: u8,
    },
}

impl fmt::Display for RenderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scene(error) => error.fmt(f),
            Self::Camera(error) => error.fmt(f),
            Self::RowTooWide { width, room } => {
                write!(f, "a row of {width} pixels does not fit a workspace for {room}")
            }
            Self::TooDeep { depth, room } => {
                write!(f, "a depth of {depth} does not fit a workspace for {room} bounces")
            }
            Self::Exposure => f.write_str("the exposure is negative, not a number or too large"),
            Self::Samples { side, most } => {
                write!(f, "a pixel takes 1 x 1 to {most} x {most} samples, not {side} x {side}")
            }
        }
    }
}

impl core::error::Error for RenderError {}

impl From<SceneError> for RenderError {
    fn from(error: SceneError) -> Self {
        Self::Scene(error)
    }
}

impl From<CameraError> for RenderError {
    fn from(error: CameraError) -> Self {
        Self::Camera(error)
    }
}

/// Tells why a row cannot be rendered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RowError {
    /// The picture has no such row.
    NoSuchRow(u32),
    /// The buffer has not one place for each pixel of the row.
    BufferLength {
        /// Pixels in a row of the picture.
        width: u32,
        /// Places in the buffer.
        length: usize,
    },
}

impl RowError {
    /// Refuses a buffer that has not one place for each pixel of a row.
    pub(crate) fn check_length(width: u32, length: usize) -> Result<(), Self> {
        if length == width as usize { Ok(()) } else { Err(Self::BufferLength { width, length }) }
    }
}

impl fmt::Display for RowError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchRow(y) => write!(f, "the picture has no row {y}"),
            Self::BufferLength { width, length } => {
                write!(f, "a row of {width} pixels needs a buffer of that length, not {length}")
            }
        }
    }
}

impl core::error::Error for RowError {}
