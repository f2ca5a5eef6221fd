//! What of a file is left out or drawn otherwise than it says: nothing of that happens in silence.

use std::collections::BTreeMap;
use std::fmt;

/// Names what is left out or drawn otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum What {
    /// A polygon or a patch whose corners lie on a line.
    Sliver,
    /// A triangle of a patch whose corners lie on a line, the rest of which is drawn.
    Piece,
    /// A ball or a cone without extent.
    Nothing,
    /// A ball or a cone of which the inside only is to be seen.
    Inside,
    /// A cone, a polygon or a patch through which light is to come.
    Opaque,
    /// A polygon that is not flat.
    Bent,
    /// A corner's normal that points to the back of its patch.
    Turned,
    /// A corner's normal that lies in its patch, or has no length.
    Level,
    /// A fill whose Ks and T are together above 1.
    Bright,
}

impl fmt::Display for What {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sliver => "its corners lie on a line: left out",
            Self::Piece => "three of its corners lie on a line: that triangle is left out",
            Self::Nothing => "it has no extent: left out",
            Self::Inside => "its inside only is to be seen: both sides are",
            Self::Opaque => "light is to come through, but it bounds no body: opaque",
            Self::Bent => "it is not flat: cut into triangles",
            Self::Turned => "a normal points to its back: turned over",
            Self::Level => "a normal lies in its plane: that of the plane is taken",
            Self::Bright => "Ks and T are together above 1: the mirror's weight is what T leaves of 1",
        })
    }
}

/// Says what of some entities is left out or drawn otherwise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// What it is.
    pub what: What,
    /// The lines that the entities begin in, counted from 1, in order.
    pub lines: Vec<usize>,
}

/// Is how many lines a note names.
const NAMED: usize = 8;

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let named: Vec<String> = self.lines.iter().take(NAMED).map(usize::to_string).collect();
        let more = self.lines.len() - named.len();
        f.write_str(if self.lines.len() == 1 { "line " } else { "lines " })?;
        f.write_str(&named.join(", "))?;
        if more > 0 {
            write!(f, " and {more} more")?;
        }
        write!(f, ": {}", self.what)
    }
}

/// Gathers notes.
#[derive(Debug)]
pub(super) struct Notes {
    /// Where lines end, in bytes.
    ends: Vec<usize>,
    found: BTreeMap<What, Vec<usize>>,
}

impl Notes {
    /// Begins with none on a text.
    pub fn on(text: &str) -> Self {
        Self { ends: text.match_indices('\n').map(|(at, _)| at).collect(), found: BTreeMap::new() }
    }

    /// Takes a note on the entity that begins at a byte of the text; a second one of its kind changes nothing.
    pub fn add(&mut self, what: What, at: usize) {
        let line = 1 + self.ends.partition_point(|end| *end < at);
        let lines = self.found.entry(what).or_default();
        if lines.last() != Some(&line) {
            lines.push(line);
        }
    }

    /// Answers all.
    pub fn all(self) -> Vec<Note> {
        self.found.into_iter().map(|(what, lines)| Note { what, lines }).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_note_names_the_first_lines_and_counts_the_others() {
        let text = "\n".repeat(20);
        let mut notes = Notes::on(&text);
        notes.add(What::Sliver, 4);
        notes.add(What::Sliver, 4);
        (0..12).for_each(|at| notes.add(What::Turned, at));
        let said: Vec<String> = notes.all().iter().map(Note::to_string).collect();
        let turned = "lines 1, 2, 3, 4, 5, 6, 7, 8 and 4 more: a normal points to its back: turned over";
        assert_eq!(said, ["line 5: its corners lie on a line: left out", turned]);
    }
}
