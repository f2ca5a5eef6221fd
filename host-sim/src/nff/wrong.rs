//! What can be wrong with a file of this format.

use std::fmt;

/// Names what is wrong with a file.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Wrong {
    /// Something else was to stand there.
    Expected {
        /// What was expected.
        what: Expected,
        /// The word that stands there; none where the file ends.
        found: Option<String>,
    },
    /// A number is not in its range.
    Range {
        /// What the number is.
        what: &'static str,
        /// Its range.
        range: &'static str,
    },
    /// The file has no entity `v`.
    NoView,
    /// An entity that stands once in a file, `v` or `b`, stands there again.
    Twice(&'static str),
    /// An object stands before all fills.
    NoFill,
    /// A cone's radii differ in sign: neither its outside nor its inside is to be seen.
    Signs,
}

/// Names what may stand in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expected {
    /// The beginning of an entity.
    Entity,
    /// This word.
    Word(&'static str),
    /// A number in decimal digits.
    Number,
    /// A number without a point and a sign.
    Count,
}

/// Is how much of a wrong word is shown.
const SHOWN: usize = 40;

impl Wrong {
    /// Makes the complaint that a word, or the end of the file, is not what was expected.
    pub fn expected(what: Expected, found: Option<&str>) -> Self {
        let shown = |word: &str| word.chars().take(SHOWN).collect();
        Self::Expected { what, found: found.map(shown) }
    }
}

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Entity => f.write_str("one of the entities v, b, l, f, c, s, p, pp"),
            Self::Word(word) => write!(f, "`{word}`"),
            Self::Number => f.write_str("a number"),
            Self::Count => f.write_str("a whole number"),
        }
    }
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Expected { what, found: Some(found) } => write!(f, "expected {what}, found `{found}`"),
            Self::Expected { what, found: None } => {
                write!(f, "expected {what}, but the file ends within this")
            }
            Self::Range { what, range } => write!(f, "{what} is to be {range}"),
            Self::NoView => f.write_str("there is no viewpoint: expected an entity v"),
            Self::Twice(entity) => write!(f, "there is an entity {entity} already"),
            Self::NoFill => f.write_str("expected a fill, an entity f, before the first object"),
            Self::Signs => f.write_str("the radii at both ends are to have the same sign"),
        }
    }
}
