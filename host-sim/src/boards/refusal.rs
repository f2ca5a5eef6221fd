use super::BOARDS;
use crate::suggest;
use std::path::PathBuf;
use std::{fmt, io};

/// Tells why no project was begun; nothing was written then.
#[derive(Debug)]
#[non_exhaustive]
pub enum Refusal {
    /// There is no crate for such a board.
    UnknownBoard(String),
    /// The folder's name cannot be that of a crate.
    NoCrateName(String),
    /// The board's firmware depends on a crate of that name.
    TakenName(String),
    /// There is something already where the project would be.
    Exists(PathBuf),
    /// The project would lie in the sources of scanray, whose own settings for firmware would be added to its.
    InsideSources(PathBuf),
    /// The sources of scanray that the project would depend on are gone.
    NoSources(PathBuf),
    /// A file or a folder cannot be written.
    Write(PathBuf, io::Error),
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownBoard(name) => {
                write!(f, "there is no board '{name}'")?;
                if let Some(nearest) = suggest::nearest(name, BOARDS.iter().map(|board| board.name)) {
                    write!(f, "; did you mean '{nearest}'?")?;
                }
                let names: Vec<_> = BOARDS.iter().map(|board| board.name).collect();
                write!(f, "\nThere are {}; `scanray new --list` tells what they are.", names.join(", "))
            }
            Self::NoCrateName(name) => write!(
                f,
                "'{name}' cannot be the name of a crate.\n\
                 A name begins with a letter, goes on with letters, digits, `-` and `_`, and means nothing to Rust yet."
            ),
            Self::TakenName(name) => {
                write!(
                    f,
                    "the firmware depends on a crate '{name}' and cannot have the same name.\nTake another."
                )
            }
            Self::Exists(path) => {
                write!(
                    f,
                    "{} exists already, and nothing in it is touched.\nTake another name.",
                    path.display()
                )
            }
            Self::InsideSources(path) => write!(
                f,
                "{} lies in the sources of scanray, whose settings for firmware of its own would be added to those of \
                 the project.\nTake a folder outside, such as ../my-picture.",
                path.display()
            ),
            Self::NoSources(path) => write!(
                f,
                "the sources of scanray that the project would depend on are no longer at {}.\n\
                 `--published` takes those of crates.io.",
                path.display()
            ),
            Self::Write(path, error) => write!(f, "cannot write {}: {error}.", path.display()),
        }
    }
}

impl std::error::Error for Refusal {}
