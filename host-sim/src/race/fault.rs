use crate::reference::Unknown;
use image::ImageError;
use rayon::ThreadPoolBuildError;
use scanray::{CameraError, RenderError};
use std::{fmt, io};

/// Tells what keeps a race from being run.
#[derive(Debug)]
#[non_exhaustive]
pub enum Fault {
    /// A program is not there.
    NotInstalled {
        /// The program.
        program: &'static str,
        /// The Debian package that holds it.
        package: &'static str,
    },
    /// A program does not do what it is asked for.
    Rival {
        /// The program.
        program: &'static str,
        /// What it printed last.
        says: String,
    },
    /// A scene has something that cannot be told to all programs.
    Unwritable(&'static str),
    /// This renderer refuses the picture.
    Core(RenderError),
    /// The reference refuses the picture.
    Reference(Unknown),
    /// There are no such threads.
    Threads(ThreadPoolBuildError),
    /// A scene file cannot be written.
    File(io::Error),
    /// A program's picture cannot be read.
    Picture(ImageError),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotInstalled { program, package } => write!(
                f,
                "{program} is not installed. Debian's package is called {package}:\n\
                 sudo apt-get install {package}"
            ),
            Self::Rival { program, says } => write!(f, "{program} drew nothing and said:\n{says}"),
            Self::Unwritable(what) => write!(f, "not every program can draw {what}"),
            Self::Core(error) => error.fmt(f),
            Self::Reference(error) => error.fmt(f),
            Self::Threads(error) => error.fmt(f),
            Self::File(error) => write!(f, "a scene file cannot be written: {error}"),
            Self::Picture(error) => write!(f, "a program's picture cannot be read: {error}"),
        }
    }
}

impl std::error::Error for Fault {}

/// Makes a fault of each error that is one as it is.
macro_rules! from {
    ($($error:ty => $fault:ident),+ $(,)?) => {
        $(impl From<$error> for Fault {
            fn from(error: $error) -> Self {
                Self::$fault(error)
            }
        })+
    };
}

from! {
    RenderError => Core,
    Unknown => Reference,
    ThreadPoolBuildError => Threads,
    io::Error => File,
    ImageError => Picture,
}

impl From<CameraError> for Fault {
    fn from(error: CameraError) -> Self {
        Self::Core(error.into())
    }
}
