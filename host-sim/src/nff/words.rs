use std::ops::Range;

/// Is a word of a file, with its place there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Word<'a> {
    pub text: &'a str,
    pub place: Range<usize>,
}

/// Splits a text into words: what stands between white space and comments.
///
/// A comment begins with `#`, in a word's midst too, and ends with the line; lines end in a line feed, a
/// carriage return or both.
#[derive(Clone, Copy, Debug)]
pub(super) struct Words<'a> {
    text: &'a str,
    /// How much of the text has been read, in bytes.
    at: usize,
}

/// Tells whether a character stands between words: white space, or the mark some editors begin a file with.
fn is_space(c: char) -> bool {
    c.is_whitespace() || c == '\u{feff}'
}

impl<'a> Words<'a> {
    /// Begins with the first word of a text.
    pub fn of(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    /// Answers the next word without taking it.
    pub fn peek(&self) -> Option<Word<'a>> {
        { *self }.next()
    }

    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or_default()
    }

    /// Passes over what a predicate holds for.
    fn skip(&mut self, passed: impl Fn(char) -> bool) {
        let rest = self.rest();
        self.at += rest.find(|c| !passed(c)).unwrap_or(rest.len());
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = Word<'a>;

    fn next(&mut self) -> Option<Word<'a>> {
        self.skip(is_space);
        while self.rest().starts_with('#') {
            self.skip(|c| !matches!(c, '\n' | '\r'));
            self.skip(is_space);
        }
        let (rest, begin) = (self.rest(), self.at);
        self.skip(|c| !is_space(c) && c != '#');
        let text = rest.get(..self.at - begin)?;
        (!text.is_empty()).then_some(Word { text, place: begin..self.at })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<&str> {
        Words::of(text).map(|word| word.text).collect()
    }

    #[test]
    fn words_stand_between_white_space_of_any_kind_and_comments() {
        assert_eq!(words("s 1\t2\r\n3\u{c}\n\n4"), ["s", "1", "2", "3", "4"]);
        assert_eq!(words("# s\ns 1#2 3\r4 # 5"), ["s", "1", "4"]);
        assert_eq!(words("\u{feff}#\n##\n\tb"), ["b"]);
        assert_eq!(words(" \r\n# all of it"), [""; 0]);
        assert_eq!(words(""), [""; 0]);
    }

    #[test]
    fn a_word_knows_its_place_and_peeking_does_not_take_it() {
        let mut words = Words::of("# ü\n pp 3");
        assert_eq!(words.peek(), words.clone().next());
        let word = words.next().expect("there is one");
        assert_eq!((word.text, word.place), ("pp", 6..8));
        assert_eq!(words.peek(), Some(Word { text: "3", place: 9..10 }));
        assert_eq!(words.next().map(|word| word.place), Some(9..10));
    }
}
