use super::Part;
use textwrap::{Options, fill, indent};

/// Is the width of the text, in characters.
const WIDTH: usize = 80;

/// Lays a part of a chapter out for a terminal, without colours; a block is set in by four columns.
pub fn laid_out(part: &Part) -> String {
    match part {
        Part::Heading(1, title) => underlined(title, "="),
        Part::Heading(_, title) => underlined(title, "-"),
        Part::Prose(text) if text.starts_with("- ") => filled(text, "  "),
        Part::Prose(text) => filled(text, "") + "\n",
        Part::Fenced(_, text) => format!("{}\n", indent(text, "    ")),
    }
}

fn underlined(title: &str, mark: &str) -> String {
    format!("\n{title}\n{}\n\n", mark.repeat(title.chars().count()))
}

/// Breaks a text into lines; all but the first are set in.
fn filled(text: &str, inset: &str) -> String {
    fill(text, Options::new(WIDTH).subsequent_indent(inset).break_words(false)) + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lessons::{CHAPTERS, Language, parts};

    #[test]
    fn no_line_of_any_chapter_is_longer_than_a_terminal_is_wide() {
        for chapter in CHAPTERS {
            for language in Language::ALL {
                let text: String = parts(chapter.text(language)).iter().map(laid_out).collect();
                let long = text.lines().find(|line| line.chars().count() > WIDTH);
                assert_eq!(long, None, "{} {}", chapter.name, language.code());
            }
        }
    }
}
