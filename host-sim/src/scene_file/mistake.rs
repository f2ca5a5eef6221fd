//! What can be wrong with a scene file, where, and what was meant.

use super::ready::Unusable;
use super::{mesh_file, png_file, voxel_file};
use crate::nff::Wrong;
use crate::suggest::nearest;
use annotate_snippets::{AnnotationKind, Level, Origin, Renderer, Snippet};
use scanray::RenderError;
use std::fmt;
use std::ops::Range;
use std::path::PathBuf;

/// Is what is wrong with a scene file, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// What is wrong.
    pub reason: Reason,
    /// Bytes of the text that are wrong, if it is not the whole.
    pub place: Option<Range<usize>>,
}

/// Names what is wrong with a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reason {
    /// It has more bytes than this.
    TooLarge(u64),
    /// It is not UTF-8 from this byte on.
    NotText(usize),
    /// It is not RON, or not a scene: a field or a variant that there is not, a value of another kind.
    Form(ron::Error),
    /// An object names a material that there is not.
    NoSuchMaterial {
        /// The name.
        name: String,
        /// The material that was meant, if any is like it.
        meant: Option<String>,
    },
    /// Two materials have this name.
    SameName(String),
    /// A material has no colour and no texture, or both.
    Paint,
    /// There are more things in a list than this.
    TooMany(usize),
    /// The picture has a side of 0 or of more pixels than this.
    Size(u32),
    /// An image cannot be read.
    Image {
        /// Where it was looked for.
        path: PathBuf,
        /// Why it cannot be read.
        why: png_file::Unreadable,
    },
    /// A mesh cannot be read.
    Mesh {
        /// Where it was looked for.
        path: PathBuf,
        /// Why it cannot be read.
        why: mesh_file::Unreadable,
    },
    /// Voxels cannot be read.
    Voxels {
        /// Where they were looked for.
        path: PathBuf,
        /// Why they cannot be read.
        why: voxel_file::Unreadable,
    },
    /// The fields of a mesh make none of its triangles.
    Unusable(Unusable),
    /// It is not as the Neutral File Format has it.
    Nff(Wrong),
    /// The core cannot draw it.
    Refused(RenderError),
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge(most) => write!(f, "the file has more than {most} bytes"),
            Self::NotText(byte) => write!(f, "the file is not UTF-8 text: byte {byte} begins no letter"),
            Self::Form(error) => form(f, error),
            Self::NoSuchMaterial { name, meant } => unknown(f, "material", name, meant.as_deref()),
            Self::SameName(name) => write!(f, "there are two materials `{name}`"),
            Self::Paint => f.write_str("a material has either `color` or `texture`"),
            Self::TooMany(most) => write!(f, "there are more than {most} of them"),
            Self::Size(most) => write!(f, "a picture has 1 to {most} pixels along each side"),
            Self::Image { path, why } => write!(f, "cannot read the image {}: {why}", path.display()),
            Self::Mesh { path, why } => write!(f, "cannot read the mesh {}: {why}", path.display()),
            Self::Voxels { path, why } => write!(f, "cannot read the voxels {}: {why}", path.display()),
            Self::Unusable(why) => why.fmt(f),
            Self::Nff(wrong) => wrong.fmt(f),
            Self::Refused(error) => error.fmt(f),
        }
    }
}

/// Says what is not as the format has it.
fn form(f: &mut fmt::Formatter<'_>, error: &ron::Error) -> fmt::Result {
    match error {
        ron::Error::NoSuchStructField { expected, found, .. } => {
            unknown(f, "field", found, nearest(found, expected.iter().copied()))
        }
        ron::Error::NoSuchEnumVariant { expected, found, outer } => {
            let kind = outer.as_deref().unwrap_or("variant").to_lowercase();
            unknown(f, &kind, found, nearest(found, expected.iter().copied()))
        }
        ron::Error::MissingStructField { field, .. } => write!(f, "the field `{field}` is missing"),
        ron::Error::DuplicateStructField { field, .. } => write!(f, "the field `{field}` is there twice"),
        other => f.write_str(&begin_small(&other.to_string())),
    }
}

fn unknown(f: &mut fmt::Formatter<'_>, kind: &str, name: &str, meant: Option<&str>) -> fmt::Result {
    write!(f, "unknown {kind} `{name}`")?;
    meant.map_or(Ok(()), |meant| write!(f, ", did you mean `{meant}`?"))
}

fn begin_small(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

impl Reason {
    /// Answers the words that may stand there instead, if there are not too many to name.
    fn known(&self) -> Option<String> {
        let Self::Form(error) = self else { return None };
        let (outer, known) = match error {
            ron::Error::NoSuchStructField { expected, outer, .. } => (outer, expected),
            ron::Error::NoSuchEnumVariant { expected, outer, .. } => (outer, expected),
            _ => return None,
        };
        let known: Vec<String> = known.iter().map(|word| format!("`{word}`")).collect();
        let whose = outer.as_ref().map_or(String::new(), |outer| format!("{outer} has "));
        Some(whose + &known.join(", "))
    }
}

/// Is a mistake with the text it stands in: it shows the line, as compilers do.
#[derive(Clone, Debug)]
pub struct Complaint {
    /// The file.
    pub path: PathBuf,
    /// What is wrong with it.
    pub mistake: Mistake,
    pub(super) text: String,
}

impl Complaint {
    /// Answers the bytes to underline: those of the place's first line.
    fn underlined(&self) -> Option<Range<usize>> {
        let Range { start, end } = self.mistake.place.clone()?;
        let line = self.text.get(start..end)?.lines().next().unwrap_or_default();
        Some(start..start + line.len())
    }
}

impl fmt::Display for Complaint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = self.path.display().to_string();
        let title = Level::ERROR.no_name().primary_title(self.mistake.reason.to_string());
        let mut group = match self.underlined() {
            Some(place) => title.element(
                Snippet::source(&self.text).path(path).annotation(AnnotationKind::Primary.span(place)),
            ),
            None => title.element(Origin::path(path)),
        };
        if let Some(known) = self.mistake.reason.known() {
            group = group.element(Level::HELP.message(known));
        }
        f.write_str(&Renderer::plain().render(&[group]))
    }
}

impl std::error::Error for Complaint {}
