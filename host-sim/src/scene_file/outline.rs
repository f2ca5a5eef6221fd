//! The outline of a scene file: its parts as pieces of the text, which are read one by one so that each
//! knows its place.

use super::mistake::{Mistake, Reason};
use ron::Options;
use ron::error::{Position, SpannedError};
use ron::extensions::Extensions;
use ron::value::RawValue;
use serde::Deserialize;
use serde::de::{Deserializer, MapAccess, Visitor};
use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

/// Is a file with its parts unread.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename = "Scene")]
pub(super) struct Outline<'a> {
    #[serde(default)]
    pub about: String,
    #[serde(borrow)]
    pub size: Option<&'a RawValue>,
    pub camera: &'a RawValue,
    pub settings: Option<&'a RawValue>,
    pub sky: Option<&'a RawValue>,
    pub ambient: Option<&'a RawValue>,
    #[serde(default)]
    pub materials: Named<'a>,
    #[serde(default)]
    pub lights: Vec<&'a RawValue>,
    #[serde(default)]
    pub objects: Vec<&'a RawValue>,
    pub volume: Option<&'a RawValue>,
}

/// Is a map with its order kept.
#[derive(Default)]
pub(super) struct Named<'a>(pub Vec<(Name<'a>, &'a RawValue)>);

/// Is a name, borrowed from the text unless it has escapes.
#[derive(Deserialize)]
#[serde(transparent)]
pub(super) struct Name<'a>(#[serde(borrow)] pub Cow<'a, str>);

impl<'de: 'a, 'a> Deserialize<'de> for Named<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(InOrder)
    }
}

/// Takes a map entry by entry.
struct InOrder;

impl<'de> Visitor<'de> for InOrder {
    type Value = Named<'de>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("names with what they name, such as { \"red\": (color: (0.9, 0.2, 0.1)) }")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Named<'de>, A::Error> {
        let mut entries = vec![];
        while let Some(entry) = map.next_entry()? {
            entries.push(entry);
        }
        Ok(Named(entries))
    }
}

/// Answers how values are written: `near: 30` for `near: Some(30)`, `Image(file: ...)` for
/// `Image((file: ...))`.
pub(super) fn options() -> Options {
    Options::default()
        .with_default_extension(Extensions::IMPLICIT_SOME)
        .with_default_extension(Extensions::UNWRAP_VARIANT_NEWTYPES)
}

/// Is the text that is being read.
#[derive(Clone, Copy)]
pub(super) struct Text<'a>(pub &'a str);

impl<'a> Text<'a> {
    /// Reads the whole text as one value.
    pub fn whole<T: Deserialize<'a>>(self) -> Result<T, Mistake> {
        self.read(0..self.0.len())
    }

    /// Answers where a piece of this text stands in it; `None` for a text from elsewhere.
    pub fn find(self, piece: &str) -> Option<Range<usize>> {
        let begin = (piece.as_ptr() as usize).checked_sub(self.0.as_ptr() as usize)?;
        let place = begin..begin.checked_add(piece.len())?;
        self.0.get(place.clone()).map(|_| place)
    }

    /// Answers where a part of the outline stands, without the white space and comments around it.
    pub fn place(self, part: &RawValue) -> Range<usize> {
        // It was borrowed from this text.
        self.find(part.trim().get_ron()).unwrap_or_default()
    }

    /// Answers where a name stands in a part; the whole part if escapes hide the name there.
    pub fn place_of_name(self, part: Range<usize>, name: &str) -> Range<usize> {
        let piece = self.0.get(part.clone()).unwrap_or_default();
        piece.find(&format!("\"{name}\"")).map_or(part.clone(), |quote| {
            let begin = part.start + quote + 1;
            begin..begin + name.len()
        })
    }

    /// Reads a piece of the text as one value.
    pub fn read<T: Deserialize<'a>>(self, place: Range<usize>) -> Result<T, Mistake> {
        let piece = self.0.get(place.clone()).unwrap_or_default();
        options().from_str(piece).map_err(|SpannedError { code, span }| {
            let wrong = offset(piece, span.start)..offset(piece, span.end);
            let wrong = tightened(piece, wrong);
            Mistake {
                reason: Reason::Form(code),
                place: Some(place.start + wrong.start..place.start + wrong.end),
            }
        })
    }
}

/// Answers how many bytes of a text stand before a position.
fn offset(text: &str, position: Position) -> usize {
    let line = text.split_inclusive('\n').take(position.line.saturating_sub(1)).map(str::len).sum();
    let rest = text.get(line..).unwrap_or_default();
    let before = rest.chars().take(position.col.saturating_sub(1)).map(char::len_utf8);
    line + before.sum::<usize>()
}

/// Answers a place without the white space it begins with: what is wrong is the word behind it.
fn tightened(text: &str, place: Range<usize>) -> Range<usize> {
    let rest = text.get(place.start..).unwrap_or_default();
    let word = rest.trim_start();
    let begin = if word.is_empty() { place.start } else { text.len() - word.len() };
    begin..place.end.max(begin)
}
