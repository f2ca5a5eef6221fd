//! Looks: what decides the picture of a scene, in the words of a page.

use crate::fault::Fault;
use crate::walk::Walk;
use host_sim::dither::Method;
use host_sim::panel::Panel;
use host_sim::picture::MAX_DEPTH;
use host_sim::scenes::Entry;
use host_sim::shot::{Approach, Number, Quality, Sampling, Shot};
use scanray::Uniform;
use serde::Deserialize;

/// Lists the words for how many rays a picture takes.
pub const QUALITIES: [&str; 6] =
    ["exact", "adaptive", "uniform", "jittered", "at-edges", "at-edges-jittered"];

/// Is the longest side of a picture: that of the largest displays of the field, and what a page draws in seconds.
pub const MOST_PIXELS: u32 = 1024;

/// Is what decides a picture, in words.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Look {
    /// The number it is traced in, or the reference.
    pub number: String,
    /// Who draws it: one of [`Approach::ALL`].
    pub approach: String,
    /// The colour format of the display.
    pub panel: String,
    /// Columns and rows.
    pub size: [u32; 2],
    /// How many mirrors light may have met.
    pub depth: u8,
    /// How much of it is traced: one of [`QUALITIES`].
    pub quality: String,
    /// Rays along a side of a pixel, where it takes several.
    pub side: u8,
    /// How levels are rounded.
    pub dither: String,
    /// Where it is seen from.
    #[serde(default)]
    pub walk: Walk,
}

/// Finds what a word of a choice names.
fn find<T: Copy>(all: &[T], name: fn(T) -> &'static str, what: &'static str, word: &str) -> Result<T, Fault> {
    let found = all.iter().copied().find(|choice| name(*choice) == word);
    found.ok_or_else(|| Fault::UnknownWord(what, word.to_owned()))
}

impl Look {
    /// Answers the shot of a scene that it describes.
    ///
    /// # Errors
    /// The first word or number in it that there is not.
    pub fn shot(&self, scene: Entry) -> Result<Shot, Fault> {
        if !self.size.iter().all(|side| (1..=MOST_PIXELS).contains(side)) {
            return Err(Fault::Size(MOST_PIXELS));
        }
        if usize::from(self.depth) > MAX_DEPTH {
            return Err(Fault::TooMany("mirrors", MAX_DEPTH));
        }
        let mut shot = Shot::new(scene);
        shot.number = find(&Number::ALL, Number::name, "number", &self.number)?;
        shot.approach = find(&Approach::ALL, Approach::name, "approach", &self.approach)?;
        shot.panel = find(&Panel::ALL, Panel::name, "panel", &self.panel)?;
        shot.dither = find(&Method::ALL, Method::name, "dither", &self.dither)?.dither();
        shot.quality = self.quality()?;
        shot.camera = self.walk.carry(scene.double);
        (shot.size, shot.depth) = (self.size, self.depth);
        Ok(shot)
    }

    fn quality(&self) -> Result<Quality, Fault> {
        let (jittered, at_edges) = match find(&QUALITIES, |word| word, "quality", &self.quality)? {
            "exact" => return Ok(Quality::Exact),
            "adaptive" => return Ok(Quality::Adaptive),
            word => (word.ends_with("jittered"), word.starts_with("at-edges")),
        };
        let side = self.side;
        if !(1..=Uniform::MOST).contains(&side) {
            return Err(Fault::TooMany("rays along a side of a pixel", usize::from(Uniform::MOST)));
        }
        Ok(Quality::Sampled(Sampling { side, jittered, at_edges }))
    }
}

/// Answers the word for a way of rounding.
pub fn dither_word(shot: &Shot) -> &'static str {
    let is_it = |method: &Method| method.dither() == shot.dither;
    Method::ALL.into_iter().find(is_it).map_or("none", Method::name)
}
