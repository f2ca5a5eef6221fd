//! Rust source as one likes to read it: rows of data no wider than the page.

use std::fmt::Write;

/// Is how wide a line may be.
const WIDTH: usize = 110;

/// Is what a line of data begins with; a space follows before each datum.
const INDENT: &str = "   ";

/// Is items of source, one after another.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    /// The text so far.
    pub text: String,
}

impl Layout {
    /// Writes an item: its documentation, unless there is none to be read from outside, and what it is.
    pub fn item(&mut self, about: &str, item: &str) {
        self.text.push('\n');
        if !about.is_empty() {
            let _ = writeln!(self.text, "/// {about}");
        }
        let _ = writeln!(self.text, "#[rustfmt::skip]\n{item};");
    }

    /// Writes a list of things that are told in a line each.
    pub fn list(&mut self, name: &str, kind: &str, things: &[String]) {
        let lines: String = things.iter().map(|thing| format!("    {thing},\n")).collect();
        self.item("", &format!("static {name}: [{kind}; {}] = [\n{lines}]", things.len()));
    }

    /// Writes a list of data, as many to a line as there is room for.
    pub fn rows(&mut self, name: &str, kind: &str, data: impl ExactSizeIterator<Item = String>) {
        let count = data.len();
        self.item("", &format!("static {name}: [{kind}; {count}] = [\n{}]", wrapped(data)));
    }
}

/// Writes data with commas, as many to a line as there is room for.
fn wrapped(data: impl Iterator<Item = String>) -> String {
    let (mut text, mut line) = (String::new(), String::from(INDENT));
    for datum in data {
        if line.len() + datum.len() + 2 > WIDTH {
            text = text + &line + "\n";
            line.truncate(INDENT.len());
        }
        let _ = write!(line, " {datum},");
    }
    text + &line + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_row_is_wider_than_the_page_and_none_could_take_one_more() {
        let data: Vec<String> = (0..999).map(|i| (i * 37 % 1000).to_string()).collect();
        let text = wrapped(data.iter().cloned());
        let lines: Vec<&str> = text.lines().collect();
        for (line, next) in lines.iter().zip(&lines[1..]) {
            let first = next.split_whitespace().next().unwrap();
            assert!(line.len() <= WIDTH && line.len() + 1 + first.len() > WIDTH, "{line}");
        }
        let back: Vec<&str> = text.split_whitespace().map(|datum| datum.trim_end_matches(',')).collect();
        assert_eq!(back, data);
    }
}
