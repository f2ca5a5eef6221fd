//! What keeps a request from being done.

use host_sim::bake::file::Failure;
use host_sim::files::Handed;
use host_sim::obj;
use host_sim::scene_file::{Complaint, Unsayable};
use host_sim::shot::Refusal;
use scanray::RenderError;
use std::fmt;

/// Tells what keeps a request from being done.
#[derive(Debug)]
#[non_exhaustive]
pub enum Fault {
    /// It is not JSON, or no request.
    Request(serde_json::Error),
    /// The gallery has no such scene.
    UnknownScene(String),
    /// No scene was opened yet.
    NoScene,
    /// A choice has no such word.
    UnknownWord(&'static str, String),
    /// The picture has a side of 0 or of more pixels than this.
    Size(u32),
    /// Mirrors, or rays along a side of a pixel, that there are at most so many of.
    TooMany(&'static str, usize),
    /// The pixel is not in the picture.
    NoSuchPixel([u32; 2]),
    /// The text is no scene that the core draws: the line is shown.
    Text(Box<Complaint>),
    /// The core or the reference refuses the picture.
    Refused(Refusal),
    /// Rays are not counted by who draws the picture.
    Uncounted,
    /// No file of this name was handed over.
    NoFile(String),
    /// There is no room for a file of this name.
    TooMuch(String),
    /// A file of this name is no scene.
    NotAScene(String),
    /// The model or a file that it names is broken.
    Model(obj::Mistake),
    /// The scene cannot be told in words.
    Unsayable(Unsayable),
    /// The text of a scene cannot be made.
    Words(String),
    /// There is no source for the scene.
    Source(Failure),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Request(error) => write!(f, "this is no request: {error}"),
            Self::UnknownScene(name) => write!(f, "there is no scene `{name}`"),
            Self::NoScene => f.write_str("no scene was opened"),
            Self::UnknownWord(what, word) => write!(f, "there is no {what} `{word}`"),
            Self::Size(most) => write!(f, "a picture has 1 to {most} pixels along each side"),
            Self::TooMany(what, most) => write!(f, "there are at most {most} {what}"),
            Self::NoSuchPixel([x, y]) => write!(f, "the picture has no pixel {x}, {y}"),
            Self::Text(complaint) => complaint.fmt(f),
            Self::Refused(error) => write!(f, "the picture cannot be drawn: {error}"),
            Self::Uncounted => f.write_str("rays are counted where the core traces them"),
            Self::NoFile(name) => write!(f, "the file {name} was not handed over"),
            Self::TooMuch(name) => {
                write!(f, "with {name} the files have more than {} bytes together", Handed::MOST_BYTES)
            }
            Self::NotAScene(name) => {
                write!(f, "{name} is no scene: the name of one ends in .ron, .nff or .obj")
            }
            Self::Model(mistake) => mistake.fmt(f),
            Self::Unsayable(unsayable) => unsayable.fmt(f),
            Self::Words(why) => write!(f, "the scene cannot be written: {why}"),
            Self::Source(failure) => write!(f, "the scene cannot be baked: {failure}"),
        }
    }
}

impl std::error::Error for Fault {}

impl From<Box<Complaint>> for Fault {
    fn from(complaint: Box<Complaint>) -> Self {
        Self::Text(complaint)
    }
}

impl From<RenderError> for Fault {
    fn from(error: RenderError) -> Self {
        Self::Refused(error.into())
    }
}

impl From<Refusal> for Fault {
    fn from(refusal: Refusal) -> Self {
        Self::Refused(refusal)
    }
}

impl From<obj::Mistake> for Fault {
    fn from(mistake: obj::Mistake) -> Self {
        Self::Model(mistake)
    }
}

impl From<Unsayable> for Fault {
    fn from(unsayable: Unsayable) -> Self {
        Self::Unsayable(unsayable)
    }
}

impl From<Failure> for Fault {
    fn from(failure: Failure) -> Self {
        Self::Source(failure)
    }
}
