//! A course of short chapters, from the pinhole camera to volumes, carried in the program.
//!
//! A chapter is a Markdown file of `host-sim/lessons` in each language; its fenced blocks say by their first
//! words what they are, see [`Fence`].

mod files;
mod language;
mod layout;
mod part;

pub use files::{File, needed};
pub use language::Language;
pub use layout::laid_out;
pub use part::{Fence, Part, parts};

/// Is a chapter in every language.
#[derive(Clone, Copy, Debug)]
pub struct Chapter {
    /// Its file's name without ending: two digits, a word.
    pub name: &'static str,
    texts: [&'static str; Language::ALL.len()],
}

/// Lists chapters by name, each with its texts in the order of [`Language::ALL`].
macro_rules! chapters {
    ($($name:literal)*) => {
        &[$(Chapter {
            name: $name,
            texts: [
                include_str!(concat!("../../lessons/en/", $name, ".md")),
                include_str!(concat!("../../lessons/pt/", $name, ".md")),
                include_str!(concat!("../../lessons/it/", $name, ".md")),
            ],
        }),*]
    };
}

/// Lists the course: chapter n has index n - 1.
pub const CHAPTERS: &[Chapter] = chapters![
    "01-camera"
    "02-ball"
    "03-matte"
    "04-shadows"
    "05-highlights"
    "06-chessboard"
    "07-mirrors"
    "08-glass"
    "09-triangles"
    "10-textures"
    "11-samples"
    "12-panel"
    "13-spectra"
    "14-fixed"
    "15-many"
    "16-volume"
];

impl Chapter {
    /// Finds a chapter by its number, such as `3` or `03`.
    pub fn find(number: &str) -> Option<&'static Self> {
        let number: usize = number.parse().ok()?;
        CHAPTERS.get(number.checked_sub(1)?)
    }

    /// Answers the text in a language, Markdown.
    pub fn text(&self, language: Language) -> &'static str {
        self.texts[language as usize]
    }

    /// Answers the number and the title in a language: `03 Light on a matte surface`.
    pub fn title(&self, language: Language) -> &'static str {
        let first = self.text(language).lines().next().unwrap_or_default();
        first.trim_start_matches(['#', ' '])
    }
}

/// Answers the titles of all chapters, a line each.
pub fn contents(language: Language) -> String {
    CHAPTERS.iter().map(|chapter| format!("  {}\n", chapter.title(language))).collect()
}
