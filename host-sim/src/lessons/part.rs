/// Is a part of a chapter, in the order of its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part<'t> {
    /// The line of a heading, with its depth from 1.
    Heading(usize, &'t str),
    /// Lines that are filled: a paragraph, or an item of a list with its mark.
    Prose(String),
    /// Lines that stay as they are.
    Fenced(Fence, &'t str),
}

/// Names what a fenced block is, by the words behind its first fence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fence {
    /// A command of this program that the chapter runs: `scanray`.
    Run,
    /// A command that the reader may run, whose picture differs from the chapter's: `scanray change`.
    Try,
    /// A change of the chapter's scene file that changes the picture: `diff`.
    Change,
    /// A change of the chapter's scene file that changes no pixel: `diff same`.
    Same,
    /// A formula: `formula`.
    Formula,
    /// Words of what the chapter's command prints: `prints`.
    Prints,
}

impl Fence {
    /// Answers what a block is; none for words of no meaning.
    pub fn of(words: &str) -> Option<Self> {
        Some(match words {
            "scanray" => Self::Run,
            "scanray change" => Self::Try,
            "diff" => Self::Change,
            "diff same" => Self::Same,
            "formula" => Self::Formula,
            "prints" => Self::Prints,
            _ => return None,
        })
    }
}

/// Splits the text of a chapter into its parts.
///
/// It reads the Markdown that chapters are written in: headings with `#`, paragraphs and items (`- `) set
/// apart by blank lines or marks, and fences of three backticks. A block of unknown words is a formula: it
/// stays as it is.
pub fn parts(text: &str) -> Vec<Part<'_>> {
    let mut parts = Vec::new();
    let mut rest = text;
    let mut filled = String::new();
    while !rest.is_empty() {
        let (line, after) = rest.split_once('\n').unwrap_or((rest, ""));
        rest = after;
        let heading = line.bytes().take_while(|byte| *byte == b'#').count();
        if line.trim().is_empty() || line.starts_with("- ") || line.starts_with("```") || heading > 0 {
            finish(&mut filled, &mut parts);
        }
        if let Some(words) = line.strip_prefix("```") {
            let (block, after) = rest.split_once("```\n").unwrap_or((rest, ""));
            parts.push(Part::Fenced(Fence::of(words).unwrap_or(Fence::Formula), block));
            rest = after;
        } else if heading > 0 {
            parts.push(Part::Heading(heading, line[heading..].trim()));
        } else {
            fill(&mut filled, line.trim());
        }
    }
    finish(&mut filled, &mut parts);
    parts
}

/// Adds a line to a paragraph.
fn fill(paragraph: &mut String, line: &str) {
    if !paragraph.is_empty() && !line.is_empty() {
        paragraph.push(' ');
    }
    paragraph.push_str(line);
}

/// Ends a paragraph, if there is one.
fn finish<'t>(paragraph: &mut String, parts: &mut Vec<Part<'t>>) {
    if !paragraph.is_empty() {
        parts.push(Part::Prose(std::mem::take(paragraph)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_falls_into_headings_prose_and_blocks_in_their_order() {
        let text = "# 01 A\n\nOne\ntwo.\n- red\n  ball\n- blue\n```scanray\nlist\n\nx\n```\n## B\nend";
        let prose = |text: &str| Part::Prose(text.to_owned());
        let expected = [
            Part::Heading(1, "01 A"),
            prose("One two."),
            prose("- red ball"),
            prose("- blue"),
            Part::Fenced(Fence::Run, "list\n\nx\n"),
            Part::Heading(2, "B"),
            prose("end"),
        ];
        assert_eq!(parts(text), expected);
    }
}
