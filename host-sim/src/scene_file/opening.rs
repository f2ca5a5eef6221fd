//! How a file beside a scene file is opened.

use crate::files::{Files, Open};
use crate::suggest::nearest;
use std::fmt;
use std::io;
use std::path::Path;

/// Tells why a file is not open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shut {
    /// There is no such file; one in its folder whose name is like it.
    Missing(Option<String>),
    /// It is a directory or a device.
    NotAFile,
    /// The system does not hand it out.
    Withheld(io::ErrorKind),
}

impl fmt::Display for Shut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing(None) => f.write_str("there is no such file"),
            Self::Missing(Some(meant)) => write!(f, "there is no such file, did you mean `{meant}`?"),
            Self::NotAFile => f.write_str("it is no file"),
            Self::Withheld(kind) => kind.fmt(f),
        }
    }
}

/// Opens a file.
///
/// # Errors
/// Why it cannot be opened.
pub(super) fn open<'a>(files: &'a dyn Files, path: &Path) -> Result<Open<'a>, Shut> {
    let shut = |error: io::Error| match error.kind() {
        io::ErrorKind::NotFound => Shut::Missing(meant(files, path)),
        other => Shut::Withheld(other),
    };
    files.open(path).map_err(shut)?.ok_or(Shut::NotAFile)
}

/// Answers the file beside a missing one whose name is like its.
fn meant(files: &dyn Files, path: &Path) -> Option<String> {
    let names = files.beside(path);
    nearest(path.file_name()?.to_str()?, names.iter().map(String::as_str)).map(str::to_owned)
}
