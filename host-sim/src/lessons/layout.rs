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
    fn prose_is_no_wider_than_a_terminal_and_what_is_fenced_stays_in_its_lines() {
        for chapter in CHAPTERS {
            for language in Language::ALL {
                for part in parts(chapter.text(language)) {
                    let text = laid_out(&part);
                    let width = text.lines().map(|line| line.chars().count()).max();
                    match part {
                        Part::Fenced(_, block) => assert_eq!(text.lines().count(), block.lines().count() + 1),
                        _ => assert!(width <= Some(WIDTH), "{} {}: {text}", chapter.name, language.code()),
                    }
                }
            }
        }
    }
}
