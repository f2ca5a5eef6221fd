//! The lines of an OBJ file that say something of surfaces, each checked.

use super::wrong::{Mistake, Reason};
use std::path::Path;

/// Is how many triangles a file may have: a device's flash holds fewer.
pub const MAX_TRIANGLES: usize = 1 << 18;

/// Is how often the material may change.
pub const MAX_RUNS: usize = 1 << 16;

/// Is the largest magnitude of a number.
pub const LARGEST: f64 = 1e12;

/// Is the largest magnitude of a texture coordinate, which every number can hold.
const MOST_COPIES: f64 = 1024.0;

/// Is faces in a row of one material.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Run {
    /// The material's name, if they have one.
    pub material: Option<String>,
    /// The line that names it.
    pub line: usize,
    /// How many corners they have.
    pub corners: usize,
    /// How many of these have texture coordinates.
    pub textured: usize,
    /// How many of these have a normal.
    pub smooth: usize,
}

/// Is what is in an OBJ file.
#[derive(Clone, Debug, Default)]
pub struct Survey {
    /// The checked lines, in order.
    pub text: String,
    /// Names of libraries of materials, with their lines.
    pub libraries: Vec<(String, usize)>,
    /// The faces by material, in order; those without corners too.
    pub runs: Vec<Run>,
    triangles: usize,
    /// How many `v`, `vt` and `vn` there have been.
    given: [usize; 3],
}

/// Are the words of the lines that the parts of a corner name.
const PARTS: [&str; 3] = ["v", "vt", "vn"];

/// Checks the lines of a file.
///
/// # Errors
/// The first mistake.
pub fn survey(path: &Path, text: &str) -> Result<Survey, Mistake> {
    let mut survey = Survey { runs: vec![Run::default()], ..Survey::default() };
    let mut lines = text.lines().enumerate();
    while let Some((index, line)) = lines.next() {
        let mut line = line.to_owned();
        while line.ends_with('\\') {
            line.pop();
            line.push_str(lines.next().map_or("", |(_, next)| next));
        }
        survey.take(&line, index + 1).map_err(|reason| reason.at(path, index + 1))?;
    }
    Ok(survey)
}

impl Survey {
    fn take(&mut self, line: &str, number: usize) -> Result<(), Reason> {
        let line = line.split('#').next().unwrap_or_default().trim();
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let rest = rest.trim();
        match word {
            "v" => self.place(rest)?,
            "vt" => self.numbers(1, rest, 2, MOST_COPIES)?,
            "vn" => self.numbers(2, rest, 3, LARGEST)?,
            "f" => self.face(rest)?,
            "mtllib" if rest.is_empty() => return Err(Reason::Name("mtllib")),
            "mtllib" => {
                if !self.libraries.iter().any(|(name, _)| name == rest) {
                    self.libraries.push((rest.to_owned(), number));
                }
                return Ok(());
            }
            "usemtl" if rest.is_empty() => return Err(Reason::Name("usemtl")),
            "usemtl" => self.begin_run(rest, number)?,
            _ => return Ok(()),
        }
        Ok(())
    }

    /// Keeps a line that gives something.
    fn keep(&mut self, word: &str, rest: &[&str]) {
        self.text.push_str(word);
        for part in rest {
            self.text.push(' ');
            self.text.push_str(part);
        }
        self.text.push('\n');
    }

    /// Takes a point; a colour behind it is left out.
    fn place(&mut self, rest: &str) -> Result<(), Reason> {
        let words: Vec<&str> = rest.split_whitespace().collect();
        self.numbers(0, rest, 3, LARGEST)?;
        let wrong = Reason::Numbers { word: "v", count: 3, most: LARGEST };
        match (words.len(), words.get(3)) {
            // Other weights belong to rational curves.
            (4, Some(weight)) if !number(weight, 1.0).is_some_and(|weight| weight == 1.0) => Err(wrong),
            (3 | 4 | 6, _) => Ok(()),
            _ => Err(wrong),
        }
    }

    fn numbers(&mut self, part: usize, rest: &str, count: usize, most: f64) -> Result<(), Reason> {
        let words: Vec<&str> = rest.split_whitespace().take(count).collect();
        if words.len() < count || !words.iter().all(|word| number(word, most).is_some()) {
            return Err(Reason::Numbers { word: PARTS[part], count, most });
        }
        self.given[part] += 1;
        self.keep(PARTS[part], &words);
        Ok(())
    }

    fn face(&mut self, rest: &str) -> Result<(), Reason> {
        let words: Vec<&str> = rest.split_whitespace().collect();
        if words.len() < 3 {
            return Err(Reason::Face);
        }
        self.triangles += words.len() - 2;
        if self.triangles > MAX_TRIANGLES {
            return Err(Reason::TooMany { what: "triangles", most: MAX_TRIANGLES });
        }
        for word in &words {
            let [_, textured, smooth] = self.corner(word)?;
            if let Some(run) = self.runs.last_mut() {
                run.corners += 1;
                run.textured += usize::from(textured);
                run.smooth += usize::from(smooth);
            }
        }
        self.keep("f", &words);
        Ok(())
    }

    /// Answers which parts a corner has.
    fn corner(&self, word: &str) -> Result<[bool; 3], Reason> {
        let wrong = || Reason::Corner(word.to_owned());
        let parts: Vec<&str> = word.split('/').collect();
        let mut has = [false; 3];
        if parts.len() > has.len() || parts.first().is_none_or(|part| part.is_empty()) {
            return Err(wrong());
        }
        for (((has, part), word), given) in has.iter_mut().zip(parts).zip(PARTS).zip(self.given) {
            if part.is_empty() {
                continue;
            }
            let number: i64 = part.parse().map_err(|_| wrong())?;
            // Below 0 it counts back from the last one.
            *has = number != 0 && number.unsigned_abs() <= given as u64;
            if !*has {
                return Err(Reason::Missing { word, number, given });
            }
        }
        Ok(has)
    }

    fn begin_run(&mut self, name: &str, line: usize) -> Result<(), Reason> {
        if self.runs.last().is_some_and(|run| run.material.as_deref() == Some(name)) {
            return Ok(());
        }
        if self.runs.len() == MAX_RUNS {
            return Err(Reason::TooMany { what: "changes of material", most: MAX_RUNS });
        }
        self.runs.push(Run { material: Some(name.to_owned()), line, ..Run::default() });
        self.keep("usemtl", &[name]);
        Ok(())
    }
}

/// Reads a number that is not too large.
pub(super) fn number(word: &str, most: f64) -> Option<f64> {
    word.parse().ok().filter(|number: &f64| number.abs() <= most)
}
