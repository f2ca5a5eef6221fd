//! What can be wrong with a model's files.

use crate::scene_file::png_file::Unreadable;
use crate::suggest;
use std::path::{Path, PathBuf};
use std::{fmt, io};

/// Is what is wrong with one of a model's files, and where.
#[derive(Debug)]
pub struct Mistake {
    /// The file.
    pub path: PathBuf,
    /// The line, from 1 on, if it is not the whole.
    pub line: Option<usize>,
    /// What is wrong.
    pub reason: Reason,
}

/// Names what is wrong with a model's file.
#[derive(Debug)]
#[non_exhaustive]
pub enum Reason {
    /// The system does not hand it out.
    Io(io::Error),
    /// It is a directory or a device.
    NotAFile,
    /// The system does not hand out a library of this name.
    Library(String, io::Error),
    /// It has more bytes than this.
    TooLarge(u64),
    /// Numbers are missing, or one of them is none, or too large.
    Numbers {
        /// The word that the line begins with.
        word: &'static str,
        /// How many it takes.
        count: usize,
        /// The largest magnitude.
        most: f64,
    },
    /// A face has fewer than three corners.
    Face,
    /// A corner of a face is not written `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    Corner(String),
    /// A corner of a face names what no line before it has given.
    Missing {
        /// What it names: the word of the lines that give it.
        word: &'static str,
        /// The number.
        number: i64,
        /// How many have been given.
        given: usize,
    },
    /// A name is missing.
    Name(&'static str),
    /// No library has a material of this name.
    NoSuchMaterial {
        /// The name.
        name: String,
        /// The material that was meant, if any is like it.
        meant: Option<String>,
    },
    /// A map has options, which are not understood.
    MapOption(String),
    /// There are more triangles or changes of material than this.
    TooMany {
        /// What there are too many of.
        what: &'static str,
        /// How many there may be.
        most: usize,
    },
    /// No face is left that has an area.
    Nothing,
    /// It is an image that cannot be read.
    Image(Unreadable),
    /// The reader of the format refuses it.
    Reader(tobj::LoadError),
}

impl Reason {
    /// Says where it is.
    pub fn at(self, path: &Path, line: usize) -> Mistake {
        Mistake { path: path.to_owned(), line: Some(line), reason: self }
    }

    /// Says of which file it is.
    pub fn of(self, path: &Path) -> Mistake {
        Mistake { path: path.to_owned(), line: None, reason: self }
    }

    /// Makes the mistake of a name that is not among those that there are.
    pub fn unknown<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> Self {
        let mut known: Vec<&str> = known.collect();
        known.sort_unstable();
        Self::NoSuchMaterial {
            name: name.to_owned(),
            meant: suggest::nearest(name, known).map(str::to_owned),
        }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(error) => write!(f, "cannot be read: {error}"),
            Self::NotAFile => f.write_str("it is no file"),
            Self::Library(name, error) => write!(f, "the library `{name}` cannot be read: {error}"),
            Self::TooLarge(most) => write!(f, "the file has more than {most} bytes"),
            Self::Numbers { word, count: 1, most } => {
                write!(f, "`{word}` takes a number from -{most} to {most}")
            }
            Self::Numbers { word, count, most } => {
                write!(f, "`{word}` takes {count} numbers from -{most} to {most}")
            }
            Self::Face => f.write_str("a face has three corners or more"),
            Self::Corner(text) => {
                write!(f, "`{text}` is no corner of a face: that is v, v/vt, v//vn or v/vt/vn")
            }
            Self::Missing { word, number, given } => {
                write!(f, "a corner names `{word}` {number}, and there are {given} up to here")
            }
            Self::Name(word) => write!(f, "`{word}` takes a name"),
            Self::NoSuchMaterial { name, meant } => {
                write!(f, "no library has a material `{name}`")?;
                meant.as_ref().map_or(Ok(()), |meant| write!(f, ", did you mean `{meant}`?"))
            }
            Self::MapOption(option) => write!(f, "options of maps such as `{option}` are not understood"),
            Self::TooMany { what, most } => write!(f, "there are more than {most} {what}"),
            Self::Nothing => f.write_str("there is no face that has an area"),
            Self::Image(why) => why.fmt(f),
            Self::Reader(error) => error.fmt(f),
        }
    }
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, line, reason } = self;
        match line {
            Some(line) => write!(f, "{}:{line}: {reason}", path.display()),
            None => write!(f, "{}: {reason}", path.display()),
        }
    }
}

impl std::error::Error for Mistake {}
