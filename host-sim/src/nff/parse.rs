//! Reads the words of a file, entity by entity.

use super::scene::{Fill, Light, Object, Scene, Shape, View};
use super::words::{Word, Words};
use super::wrong::{Expected, Wrong};
use crate::picture::MAX_SIDE;
use crate::scene_file::place::{Part, Places};
use crate::scene_file::read::MAX_COUNT;
use crate::scene_file::value::Point;
use crate::scene_file::{Mistake, Reason};
use scanray::Scalar;
use std::ops::Range;

/// Reads the text of a file; answers what it says, and where. Fills are in the places as materials.
///
/// Entities come in any order, but for fills, which stand before their objects: that lights and the viewpoint
/// come first is for programs that draw while they read.
///
/// # Errors
/// The first mistake in it. What the core refuses is none yet.
pub fn parse(text: &str) -> Result<(Scene, Places), Mistake> {
    let mut reader = Reader { words: Words::of(text), entity: 0..0, places: Places::new() };
    let (mut view, mut background) = (None, None);
    let (mut lights, mut fills, mut objects) = (vec![], vec![], vec![]);
    while let Some(word) = reader.words.next() {
        reader.entity = word.place.clone();
        let part = match word.text {
            "v" if view.is_some() => return Err(reader.wrong(Wrong::Twice("v"))),
            "v" => {
                view = Some(reader.view()?);
                Part::Camera
            }
            "b" if background.is_some() => return Err(reader.wrong(Wrong::Twice("b"))),
            "b" => {
                background = Some(reader.numbers()?);
                Part::Sky
            }
            "l" => Part::Light(reader.add(&mut lights, Reader::light)?),
            "f" => Part::Material(reader.add(&mut fills, Reader::fill)?),
            "c" | "s" | "p" | "pp" => {
                let fill = fills.len().checked_sub(1).ok_or_else(|| reader.wrong(Wrong::NoFill))?;
                let object = |reader: &mut Reader<'_>| Ok(Object { shape: reader.shape(word.text)?, fill });
                Part::Object(reader.add(&mut objects, object)?)
            }
            _ => return Err(expected(Expected::Entity, Some(&word), &word.place)),
        };
        reader.places.insert(part, reader.entity.clone());
    }
    let view = view.ok_or(Mistake { reason: Reason::Nff(Wrong::NoView), place: None })?;
    let scene = Scene { view, background: background.unwrap_or([0.0; 3]), lights, fills, objects };
    Ok((scene, reader.places))
}

/// Is the most corners of a polygon: an outline in disorder takes time as their square to be cut into triangles, a
/// second for these.
const MAX_CORNERS: u32 = 16_384;

/// Reads entities and remembers where they stand.
struct Reader<'a> {
    words: Words<'a>,
    /// The entity that is being read, as far as it has been.
    entity: Range<usize>,
    places: Places,
}

fn expected(what: Expected, found: Option<&Word<'_>>, entity: &Range<usize>) -> Mistake {
    let place = found.map_or(entity, |word| &word.place);
    let wrong = Wrong::expected(what, found.map(|word| word.text));
    Mistake { reason: Reason::Nff(wrong), place: Some(place.clone()) }
}

/// Reads a number that a scene may hold: finite, and of no more than the core takes in `f64`.
fn number(word: &str) -> Option<f64> {
    // What is not a number is in no range either.
    word.parse().ok().filter(|number: &f64| number.in_range())
}

impl Reader<'_> {
    /// Names what is wrong with the entity that is being read.
    fn wrong(&self, wrong: Wrong) -> Mistake {
        Mistake { reason: Reason::Nff(wrong), place: Some(self.entity.clone()) }
    }

    /// Takes the next word if it can be read.
    fn take<T>(&mut self, what: Expected, read: impl Fn(&str) -> Option<T>) -> Result<T, Mistake> {
        let word = self.words.next();
        let taken = word.as_ref().and_then(|word| read(word.text));
        let taken = taken.ok_or_else(|| expected(what, word.as_ref(), &self.entity))?;
        self.entity.end = word.map_or(self.entity.end, |word| word.place.end);
        Ok(taken)
    }

    fn word(&mut self, word: &'static str) -> Result<(), Mistake> {
        self.take(Expected::Word(word), |found| (found == word).then_some(()))
    }

    fn number(&mut self) -> Result<f64, Mistake> {
        self.take(Expected::Number, number)
    }

    fn numbers<const N: usize>(&mut self) -> Result<[f64; N], Mistake> {
        let mut numbers = [0.0; N];
        for place in &mut numbers {
            *place = self.number()?;
        }
        Ok(numbers)
    }

    fn count(&mut self) -> Result<u32, Mistake> {
        self.take(Expected::Count, |word| word.parse().ok())
    }

    /// Reads an entity into a list; answers its place there.
    fn add<T>(
        &mut self,
        list: &mut Vec<T>,
        read: impl FnOnce(&mut Self) -> Result<T, Mistake>,
    ) -> Result<usize, Mistake> {
        if list.len() == MAX_COUNT {
            return Err(Mistake { reason: Reason::TooMany(MAX_COUNT), place: Some(self.entity.clone()) });
        }
        list.push(read(self)?);
        Ok(list.len() - 1)
    }

    /// Refuses the entity unless a number of it is in its range.
    fn demand(&self, is_so: bool, what: &'static str, range: &'static str) -> Result<(), Mistake> {
        if is_so { Ok(()) } else { Err(self.wrong(Wrong::Range { what, range })) }
    }

    fn view(&mut self) -> Result<View, Mistake> {
        self.word("from")?;
        let from = self.numbers()?;
        self.word("at")?;
        let at = self.numbers()?;
        self.word("up")?;
        let up = self.numbers()?;
        self.word("angle")?;
        let angle = self.number()?;
        self.demand(angle > 0.0 && angle < 180.0, "the angle", "above 0 and below 180 degrees")?;
        self.word("hither")?;
        let hither = self.number()?;
        self.word("resolution")?;
        let resolution = [self.count()?, self.count()?];
        let usable = resolution.iter().all(|side| (1..=MAX_SIDE).contains(side));
        let too_large = || Mistake { reason: Reason::Size(MAX_SIDE), place: Some(self.entity.clone()) };
        usable.then_some(View { from, at, up, angle, hither, resolution }).ok_or_else(too_large)
    }

    fn light(&mut self) -> Result<Light, Mistake> {
        let position = self.numbers()?;
        let has_color = self.words.peek().is_some_and(|word| number(word.text).is_some());
        let color = if has_color { Some(self.numbers()?) } else { None };
        Ok(Light { position, color })
    }

    fn fill(&mut self) -> Result<Fill, Mistake> {
        let color = self.numbers()?;
        let [diffuse, specular, shine, transmittance, index] = self.numbers()?;
        for (what, value) in [("Kd", diffuse), ("Ks", specular), ("Shine", shine)] {
            self.demand(value >= 0.0, what, "at least 0")?;
        }
        self.demand((0.0..=1.0).contains(&transmittance), "T", "from 0 to 1")?;
        Ok(Fill { color, diffuse, specular, shine, transmittance, index })
    }

    fn shape(&mut self, entity: &str) -> Result<Shape, Mistake> {
        Ok(match entity {
            "c" => self.cone()?,
            "s" => Shape::Sphere { center: self.numbers()?, radius: self.number()? },
            "p" => Shape::Polygon(self.corners(Self::numbers)?),
            _ => Shape::Patch(self.corners(|reader| Ok((reader.numbers()?, reader.numbers()?)))?),
        })
    }

    fn cone(&mut self) -> Result<Shape, Mistake> {
        let (base, base_radius): (Point, _) = (self.numbers()?, self.number()?);
        let (apex, apex_radius) = (self.numbers()?, self.number()?);
        if base_radius * apex_radius < 0.0 {
            return Err(self.wrong(Wrong::Signs));
        }
        Ok(Shape::Cone { ends: [base, apex], radii: [base_radius, apex_radius] })
    }

    /// Reads as many corners as the entity says it has; no room is made for them before they are there.
    fn corners<T>(&mut self, read: impl Fn(&mut Self) -> Result<T, Mistake>) -> Result<Vec<T>, Mistake> {
        let count = self.count()?;
        self.demand((3..=MAX_CORNERS).contains(&count), "the number of corners", "from 3 to 16384")?;
        let mut corners = vec![];
        for _ in 0..count {
            corners.push(read(self)?);
        }
        Ok(corners)
    }
}
