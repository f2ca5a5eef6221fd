//! A whole file of source: what it is, then the scene.

use super::Bill;
use super::source::{Literal, Planted, Source, Unwritable};
use std::fmt::{self, Write};

/// Is a file of source, and what there is to say about it.
#[derive(Clone, Debug)]
pub struct File {
    /// The text.
    pub text: String,
    /// What is in it: what it is about, and what there is to say.
    pub facts: Vec<(&'static str, String)>,
    /// The bytes of its data.
    pub bill: Bill,
}

/// Tells why a scene cannot be baked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Failure {
    /// There is no source for something in it.
    Unwritable(Unwritable),
    /// It has more bytes of data than there may be.
    TooLarge {
        /// How many it has.
        bytes: usize,
        /// How many there may be.
        most: usize,
    },
    /// An option goes for models only, and it is none.
    NoModel(&'static str),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unwritable(unwritable) => unwritable.fmt(f),
            Self::TooLarge { bytes, most } => {
                write!(
                    f,
                    "its data has {bytes} bytes, {} more than the {most} that there may be",
                    bytes - most
                )
            }
            Self::NoModel(option) => {
                write!(f, "`{option}` goes for OBJ files: other scenes say it themselves")
            }
        }
    }
}

impl std::error::Error for Failure {}

impl From<Unwritable> for Failure {
    fn from(unwritable: Unwritable) -> Self {
        Self::Unwritable(unwritable)
    }
}

/// Writes the file of a scene.
///
/// `file` is the name of what it was made of; `facts` are what else there is to say.
///
/// # Errors
/// Something that there is no source for, or more data than `most` bytes.
pub fn write<S: Literal>(
    planted: &Planted<S>,
    file: &str,
    facts: Vec<(&'static str, String)>,
    most: Option<usize>,
) -> Result<File, Failure> {
    let Source { items, bill } = planted.write()?;
    if let Some(most) = most.filter(|most| bill.total() > *most) {
        return Err(Failure::TooLarge { bytes: bill.total(), most });
    }
    let mut counts = format!("{} objects", planted.view.scene.objects.len());
    if bill.triangle_count > 0 {
        let (triangles, corners) = (bill.triangle_count, bill.corner_count);
        let _ = write!(counts, ", {triangles} triangles of {corners} corners in meshes");
    }
    if bill.voxel_count > 0 {
        let _ = write!(counts, ", {} voxels", bill.voxel_count);
    }
    let facts = [vec![("number", S::WORD.to_owned()), ("holds", counts)], facts].concat();
    let mut text = head(planted.view.name, file, &facts);
    let _ = write!(text, "{}{PREAMBLE}{items}", table(&bill));
    Ok(File { text, facts, bill })
}

/// Is what stands between a file's documentation and its items.
const PREAMBLE: &str = "
#![allow(clippy::approx_constant, clippy::unreadable_literal, reason = \"these numbers are data\")]

use scanray::*;
";

fn head(name: &str, file: &str, facts: &[(&str, String)]) -> String {
    let mut text = format!(
        "//! The scene `{name}`, made of `{file}` by `scanray bake`.\n//!\n\
         //! It is a module of any program that depends on `scanray`: `Renderer::new` takes its `SCENE`, `CAMERA`\n\
         //! and `SETTINGS`.\n//!\n"
    );
    for (about, say) in facts {
        let _ = writeln!(text, "//! - {about}: {say}");
    }
    text
}

fn table(bill: &Bill) -> String {
    let mut text = String::from("//!\n//! | data | bytes of flash |\n//! |---|--:|\n");
    for (kind, bytes) in bill.items() {
        let _ = writeln!(text, "//! | {kind} | {bytes} |");
    }
    let _ = writeln!(
        text,
        "//! | all | {} |\n//!\n//! Meshes, objects and materials hold addresses: they are counted with {} bits each,\n\
         //! and are smaller on a device.",
        bill.total(),
        usize::BITS
    );
    text
}
