//! What became of many scenes.

use scanray::RenderError;
use std::collections::BTreeMap;
use std::fmt;
use std::time::Duration;

/// Counts scenes.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    pub scenes: u64,
    pub drawn: u64,
    /// How many were refused, by what was wrong with them.
    pub refused: BTreeMap<String, u64>,
    /// The first of those that panicked: none should.
    pub panicked: Vec<u64>,
    /// How long the slowest took, and its number.
    pub slowest: (Duration, u64),
}

/// Is how many numbers of scenes that panicked are told.
const TOLD: usize = 12;

/// Is what became of a scene: an error of its own where it panicked.
pub type End = std::thread::Result<Result<(), RenderError>>;

/// Names what is wrong without saying where.
fn kind(error: &RenderError) -> String {
    let said = format!("{error:?}");
    said.chars().filter(|c| !c.is_ascii_digit()).collect::<String>().replace("(, ", "(")
}

impl Tally {
    pub fn of(number: u64, end: &End, time: Duration) -> Self {
        let mut tally = Self { scenes: 1, slowest: (time, number), ..Self::default() };
        match end {
            Ok(Ok(())) => tally.drawn = 1,
            Ok(Err(error)) => drop(tally.refused.insert(kind(error), 1)),
            Err(_) => tally.panicked.push(number),
        }
        tally
    }

    pub fn and(mut self, other: Self) -> Self {
        self.scenes += other.scenes;
        self.drawn += other.drawn;
        for (kind, count) in other.refused {
            *self.refused.entry(kind).or_default() += count;
        }
        self.panicked.extend(other.panicked);
        self.panicked.truncate(TOLD);
        self.slowest = self.slowest.max(other.slowest);
        self
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { scenes, drawn, refused, panicked, slowest: (time, number) } = self;
        writeln!(f, "{scenes} scenes, {drawn} drawn, the slowest, {number}, in {time:.1?}")?;
        if !panicked.is_empty() {
            writeln!(f, "these panicked: {panicked:?}")?;
        }
        let mut kinds: Vec<_> = refused.iter().collect();
        kinds.sort_unstable_by_key(|(kind, count)| (u64::MAX - *count, *kind));
        for (kind, count) in kinds {
            writeln!(f, "{count:>9} refused: {kind}")?;
        }
        Ok(())
    }
}
