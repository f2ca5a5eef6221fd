//! A scene file on disk, as a scene that commands take.

use super::album::{self, Missed, Shelf};
use super::beside::Beside;
use super::description::Description;
use super::mistake::{Complaint, Mistake, Reason};
use super::outline::Text;
use super::place::{Part, Places};
use super::read::parse;
use crate::files::{Disk, Files};
use crate::nff::{self, Note};
use scanray::RenderError;
use std::fmt;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Is the largest file that is read, in bytes: room for 65535 objects of 250 bytes each.
pub const MAX_BYTES: u64 = 1 << 24;

/// Is a scene file that has been read.
#[derive(Clone, Debug)]
pub struct SceneFile {
    path: PathBuf,
    name: String,
    text: String,
    places: Places,
    description: Description,
    /// The same in other units, if the file asks for them.
    drawn: Option<Description>,
    notes: Vec<Note>,
}

/// Tells why a scene file cannot be read.
#[derive(Debug)]
#[non_exhaustive]
pub enum Failure {
    /// The system does not hand it out.
    Io(PathBuf, io::Error),
    /// Something is wrong with what it says.
    Wrong(Box<Complaint>),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(path, error) => write!(f, "cannot read {}: {error}", path.display()),
            Self::Wrong(complaint) => complaint.fmt(f),
        }
    }
}

impl std::error::Error for Failure {}

impl SceneFile {
    /// Reads a file of at most [`MAX_BYTES`].
    ///
    /// # Errors
    /// The system's refusal, or the first mistake in the file.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let mut bytes = vec![];
        let file = File::open(path).and_then(|file| file.take(MAX_BYTES + 1).read_to_end(&mut bytes));
        file.map_err(|error| Failure::Io(path.to_owned(), error))?;
        Self::parse(path, bytes).map_err(Failure::Wrong)
    }

    /// Reads the bytes of a file, and the files that it names.
    ///
    /// # Errors
    /// The first mistake in them: what keeps the core from drawing it in `f64` among others, but not what is
    /// too large for smaller numbers.
    pub fn parse(path: &Path, bytes: Vec<u8>) -> Result<Self, Box<Complaint>> {
        Self::parse_beside(path, bytes, &[], &Disk)
    }

    /// Reads the bytes of a file that may name files whose content is already known, and others of a place.
    ///
    /// # Errors
    /// As there.
    pub fn parse_beside(
        path: &Path,
        bytes: Vec<u8>,
        known: &[Beside],
        files: &dyn Files,
    ) -> Result<Self, Box<Complaint>> {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let path = path.to_owned();
        let is_nff = nff::is_named(&path);
        let text = match text(bytes, is_nff) {
            Ok(text) => text,
            Err(reason) => {
                let mistake = Mistake { reason, place: None };
                return Err(Box::new(Complaint { path, mistake, text: String::new() }));
            }
        };
        let read = if is_nff { nff::read(&text) } else { parse(&text).map(nff::Read::from) };
        let nff::Read { mut description, drawn, places, notes } = match read {
            Ok(read) => read,
            Err(mistake) => return Err(Box::new(Complaint { path, mistake, text })),
        };
        let shelf = Shelf { folder: path.parent().unwrap_or(Path::new("")), files, known };
        if let Err(missed) = album::read(&mut description, shelf) {
            return Err(Box::new(Complaint { path, mistake: mistake(missed, &text, &places), text }));
        }
        let file = Self { path, name, text, places, description, drawn, notes };
        match file.description.refusal() {
            Some(error) => Err(Box::new(file.explain(error))),
            None => Ok(file),
        }
    }

    /// Answers the name of the file.
    pub fn file_name(&self) -> String {
        self.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Answers the text of the file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Answers what the file says.
    pub fn description(&self) -> &Description {
        &self.description
    }

    /// Answers what is drawn: the same, in other units if lengths of the file's would not suit every number.
    pub fn drawn(&self) -> &Description {
        self.drawn.as_ref().unwrap_or(&self.description)
    }

    /// Answers what of the file is left out or drawn otherwise.
    pub fn notes(&self) -> &[Note] {
        &self.notes
    }

    /// Shows the line that an error of the core is about.
    pub fn explain(&self, error: RenderError) -> Complaint {
        let place = Part::of(&error).and_then(|part| self.places.get(&part).cloned());
        let mistake = Mistake { reason: Reason::Refused(error), place };
        Complaint { path: self.path.clone(), mistake, text: self.text.clone() }
    }

    /// Answers the name of the scene: that of the file without its ending.
    pub fn name(&self) -> &str {
        &self.name
    }
}

/// Shows where a file names another one that cannot be read.
fn mistake(missed: Missed, text: &str, places: &Places) -> Mistake {
    let Missed { part, name, reason } = missed;
    let place = places.get(&part).map(|part| Text(text).place_of_name(part.clone(), &name));
    Mistake { reason, place }
}

/// Makes text of bytes. That of NFF is ASCII but for comments, which are in whatever letters their authors had.
fn text(bytes: Vec<u8>, is_nff: bool) -> Result<String, Reason> {
    if bytes.len() as u64 > MAX_BYTES {
        return Err(Reason::TooLarge(MAX_BYTES));
    }
    if is_nff {
        return Ok(String::from_utf8_lossy(&bytes).into_owned());
    }
    String::from_utf8(bytes).map_err(|error| Reason::NotText(error.utf8_error().valid_up_to()))
}
