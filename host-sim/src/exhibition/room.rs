use crate::compare::{Comparison, Figures, difference};
use crate::cost::{Map, Uncounted, count};
use crate::panel::Panel;
use crate::picture::{self, Film};
use crate::scenes::HostNumber;
use crate::shot::{Number, Picture, Refusal, Shot};
use scanray::Fixed;

/// Is a picture of a scene in a number on a panel.
#[derive(Clone, Debug)]
pub struct Work {
    /// The number it is traced in.
    pub number: Number,
    /// The panel that shows it.
    pub panel: Panel,
    /// What the panel shows.
    pub picture: Picture,
    /// How far it is from the reference; none of the reference itself.
    pub figures: Option<Figures>,
    /// Where it differs from the reference, sixteenfold; of one panel alone, as the others say the same.
    pub difference: Option<Picture>,
}

impl Work {
    /// Answers the name of the picture's file.
    pub fn file(&self) -> String {
        format!("{}-{}.png", self.number.name(), self.panel.name())
    }

    /// Answers the name of the file of the difference.
    pub fn difference_file(&self) -> String {
        format!("{}-difference.png", self.number.name())
    }
}

/// Is a scene with all of its pictures, and what they cost.
#[derive(Clone, Debug)]
pub struct Room {
    /// What decides the pictures, but for number and panel.
    pub shot: Shot,
    /// The pictures: number by number, panel by panel.
    pub works: Vec<Work>,
    /// What each pixel takes.
    pub map: Map,
}

impl Room {
    /// Draws all pictures of a shot.
    ///
    /// # Errors
    /// What keeps one of them from being drawn, or its cost from being counted.
    pub fn hang(shot: Shot) -> Result<Self, Unhung> {
        let reference = shot.reference(|_| ())?;
        let mut works = vec![];
        works.extend(in_number::<f32>(&shot, Number::F32, &reference)?);
        works.extend(in_number::<Fixed>(&shot, Number::Fixed, &reference)?);
        works.extend(in_number::<f64>(&shot, Number::Exact, &reference)?);
        works.extend(Panel::ALL.map(|panel| {
            let picture = Picture { size: shot.size, pixels: reference.on_panel(panel) };
            Work { number: Number::Oracle, panel, picture, figures: None, difference: None }
        }));
        Ok(Self { shot, works, map: count(&shot, |_| ())? })
    }

    /// Answers the picture of a number on a panel.
    pub fn work(&self, number: Number, panel: Panel) -> Option<&Work> {
        self.works.iter().find(|work| (work.number, work.panel) == (number, panel))
    }
}

/// Traces a picture once, and shows it on every panel.
fn in_number<S: HostNumber>(
    shot: &Shot,
    number: Number,
    reference: &Comparison,
) -> Result<Vec<Work>, Refusal> {
    let view = shot.view::<S>();
    let film: Film<S> = picture::trace(&view, view.settings, shot.size, |_| ())?;
    let works = Panel::ALL.map(|panel| {
        let pixels = film.on_panel(panel, shot.transfer, shot.dither);
        let picture = Picture { size: shot.size, pixels };
        let figures = Shot { number, panel, ..*shot }.judge(&picture, reference);
        let difference = (panel == shot.panel).then(|| {
            let pixels = difference(&picture.pixels, &reference.on_panel(panel), &reference.mask);
            Picture { size: shot.size, pixels }
        });
        Work { number, panel, picture, figures: Some(figures), difference }
    });
    Ok(works.into())
}

/// Tells what keeps a scene from being shown.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Unhung {
    /// A picture is refused.
    Picture(Refusal),
    /// Its cost cannot be counted.
    Cost(Uncounted),
}

impl From<Refusal> for Unhung {
    fn from(refusal: Refusal) -> Self {
        Self::Picture(refusal)
    }
}

impl From<scanray::RenderError> for Unhung {
    fn from(error: scanray::RenderError) -> Self {
        Self::Picture(error.into())
    }
}

impl From<Uncounted> for Unhung {
    fn from(uncounted: Uncounted) -> Self {
        Self::Cost(uncounted)
    }
}
