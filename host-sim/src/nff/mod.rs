//! Neutral File Format: the scenes of E. Haines's Standard Procedural Databases, and what else is in it.
//!
//! The format is that of *Neutral File Format*, version 3.9 of 1996, which comes with the databases (E. Haines,
//! *A Proposal for Standard Graphics Environments*, IEEE Computer Graphics and Applications 7(11), 1987).
//! `docs/nff.md` says how each of its fields is understood. A text goes through three steps:
//!
//! - `words`: words between white space and comments, each with its place.
//! - [`mod@parse`]: words to a [`scene`], which says what the file says and no more; [`wrong`]: what may be wrong.
//! - [`mod@describe`]: that scene as the [`Description`] that scene files of RON become too, by way of
//!   `fill`, `round` and `face`; [`note`]: what of it is left out or drawn otherwise.

pub mod describe;
mod face;
mod fill;
pub mod note;
pub mod parse;
mod round;
pub mod scene;
mod words;
pub mod wrong;

pub use describe::describe;
pub use note::Note;
pub use parse::parse;
pub use scene::Scene;
pub use wrong::Wrong;

use crate::scene_file::place::Places;
use crate::scene_file::{Description, Mistake};
use scanray::math::Units;
use std::path::Path;

/// Is what a file holds, as commands take it.
#[derive(Clone, Debug)]
pub struct Read {
    /// What the file says, in its own units.
    pub description: Description,
    /// The same in units in which fixed point has its digits.
    pub drawn: Option<Description>,
    /// Where its parts stand.
    pub places: Places,
    /// What is left out or drawn otherwise than the file has it.
    pub notes: Vec<Note>,
}

impl From<(Description, Places)> for Read {
    fn from((description, places): (Description, Places)) -> Self {
        Self { description, drawn: None, places, notes: vec![] }
    }
}

/// Tells by its name whether a file is in this format: it ends in `.nff`, in letters of either case.
pub fn is_named(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("nff"))
}

/// Reads the text of a file.
///
/// # Errors
/// The first mistake in it.
pub fn read(text: &str) -> Result<Read, Mistake> {
    let (scene, places) = parse(text)?;
    let units = Units::for_largest(scene.largest());
    let (drawn, ..) = describe(&scene.scaled(units.scale()), &places, text)?;
    let (description, places, notes) = describe(&scene, &places, text)?;
    Ok(Read { description, drawn: Some(drawn), places, notes })
}
