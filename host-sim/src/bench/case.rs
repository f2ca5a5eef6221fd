use super::{CHIPS, Chip, Row, SCENES, SHOWS};
use crate::scenes::{self, Entry};

/// Is a picture to measure.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// What it shows.
    pub scene: Entry,
    /// What draws it.
    pub chip: &'static Chip,
    /// How it is made.
    pub mode: &'static str,
}

/// Chooses what to measure; nothing chosen is everything.
#[derive(Clone, Copy, Debug, Default)]
pub struct Choice<'a> {
    /// The only scene, one of the gallery.
    pub scene: Option<&'a str>,
    /// The only chip.
    pub chip: Option<&'static Chip>,
    /// Whether a sample is enough: three-spheres in every mode on every chip, each other scene on one chip.
    pub sample: bool,
}

/// Names the scene of which a sample leaves out nothing: that of all modes.
const WHOLE: &str = "three-spheres";

/// Names the ways in which a scene is drawn for the table: all of those for the peers' scenes.
fn modes(scene: &str) -> &'static [&'static str] {
    match scene {
        WHOLE => &["exact", "adaptive", "uniform", "jittered", "at-edges", "progressive", "raster"],
        "simple" => &["exact", "adaptive", "raster"],
        "z-buffer" => &["exact", "raster"],
        _ if SHOWS.contains(&scene) => &["exact"],
        _ => &["exact", "adaptive"],
    }
}

impl Choice<'_> {
    /// Answers the scenes to measure.
    pub fn scenes(&self) -> Vec<Entry> {
        match self.scene {
            Some(name) => scenes::find(name).into_iter().collect(),
            None => SCENES.iter().chain(&SHOWS).filter_map(|name| scenes::find(name)).collect(),
        }
    }

    /// Answers the chips to measure on.
    pub fn chips(&self) -> impl Iterator<Item = &'static Chip> {
        CHIPS.iter().filter(|chip| self.chip.is_none_or(|only| only.name == chip.name))
    }

    /// Answers the pictures to measure, scene after scene.
    pub fn cases(&self) -> Vec<Case> {
        let mut cases = vec![];
        for (place, scene) in self.scenes().into_iter().enumerate() {
            for chip in self.chips() {
                let modes = modes(scene.name()).iter().map(|mode| Case { scene, chip, mode });
                cases.extend(modes.filter(|case| !self.sample || case.is_sampled(place)));
            }
        }
        cases
    }
}

impl Case {
    /// Tells whether a row is of this picture.
    pub fn is_of(&self, row: &Row) -> bool {
        let number = self.chip.number.name();
        [self.scene.name(), self.chip.name, number, self.mode]
            == [&row.scene, &row.chip, &row.number, &row.mode]
    }

    /// Tells whether a sample has this picture of the scene in that place of the list: chips take turns.
    fn is_sampled(&self, place: usize) -> bool {
        // Whoever begins, a third of the scenes is each chip's; so begun, the one of most work, `phantom`, is the
        // M4F's, on which it takes a third of the M0+'s instructions.
        let turn = CHIPS[(place + 1) % CHIPS.len()].name;
        self.scene.name() == WHOLE || self.mode == "exact" && self.chip.name == turn
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_has_every_scene_and_every_mode_on_every_chip_but_less_than_half_of_all() {
        let [all, some] = [false, true].map(|sample| Choice { sample, ..Choice::default() }.cases());
        for case in &all {
            assert!(some.iter().any(|other| other.scene.name() == case.scene.name()), "{case:?}");
            let same = |other: &&Case| (other.chip.name, other.mode) == (case.chip.name, case.mode);
            assert!(some.iter().any(|other| same(&other)), "{case:?}");
        }
        assert!(2 * some.len() < all.len(), "{} of {}", some.len(), all.len());
    }
}
