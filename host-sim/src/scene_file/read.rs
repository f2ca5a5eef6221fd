//! Reads the text of a scene file: the outline, then each part, then what the parts say of each other.

use super::description::{Description, SIZE};
use super::material::Material;
use super::mistake::{Mistake, Reason};
use super::outline::{Named, Outline, Text};
use super::place::{Part, Places};
use super::shape::Shape;
use crate::picture::MAX_SIDE;
use crate::suggest::nearest;
use ron::value::RawValue;
use serde::Deserialize;
use std::borrow::Cow;
use std::collections::HashMap;

/// Is how many things a list may hold: as many as the core can number.
pub const MAX_COUNT: usize = u16::MAX as usize;

/// Is an object as a file has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Object<'a> {
    shape: Shape,
    #[serde(borrow)]
    material: Cow<'a, str>,
}

/// Reads the text of a scene file; answers what it says, and where.
///
/// # Errors
/// The first mistake in it. What is too large for a number type, or more than the core draws, is no mistake
/// of the text: the core says so when it is to draw the scene.
pub fn parse(text: &str) -> Result<(Description, Places), Mistake> {
    let text = Text(text);
    let mut reader = Reader { text, places: Places::new() };
    let outline: Outline<'_> = text.whole()?;
    let (materials, names) = reader.materials(outline.materials)?;
    let description = Description {
        about: outline.about,
        size: reader.size(outline.size)?,
        camera: reader.part(Part::Camera, outline.camera)?,
        settings: reader.optional(Part::Settings, outline.settings)?.unwrap_or_default(),
        sky: reader.optional(Part::Sky, outline.sky)?,
        ambient: reader.optional(Part::Ambient, outline.ambient)?,
        lights: reader.list(Part::Light, &outline.lights)?,
        objects: reader.objects(&outline.objects, &names)?,
        volume: reader.optional(Part::Volume, outline.volume)?,
        materials,
    };
    Ok((description, reader.places))
}

/// Reads parts and remembers where they stand.
struct Reader<'a> {
    text: Text<'a>,
    places: Places,
}

impl<'a> Reader<'a> {
    fn part<T: Deserialize<'a>>(&mut self, part: Part, raw: &'a RawValue) -> Result<T, Mistake> {
        let place = self.text.place(raw);
        self.places.insert(part, place.clone());
        self.text.read(place)
    }

    fn optional<T: Deserialize<'a>>(
        &mut self,
        part: Part,
        raw: Option<&'a RawValue>,
    ) -> Result<Option<T>, Mistake> {
        raw.map(|raw| self.part(part, raw)).transpose()
    }

    fn list<T: Deserialize<'a>>(
        &mut self,
        part: fn(usize) -> Part,
        raws: &[&'a RawValue],
    ) -> Result<Vec<T>, Mistake> {
        if let Some(first_too_many) = raws.get(MAX_COUNT) {
            let place = self.text.place(first_too_many);
            return Err(Mistake { reason: Reason::TooMany(MAX_COUNT), place: Some(place) });
        }
        raws.iter().enumerate().map(|(index, raw)| self.part(part(index), raw)).collect()
    }

    /// Names what is wrong with a part that has been read.
    fn mistake(&self, part: Part, reason: Reason) -> Mistake {
        Mistake { reason, place: self.places.get(&part).cloned() }
    }

    /// Names what is wrong with a name; shows the part it stands in if escapes hide it in the text.
    fn mistake_of_name(&self, name: &str, part: Part, reason: Reason) -> Mistake {
        match self.text.find(name) {
            Some(place) => Mistake { reason, place: Some(place) },
            None => self.mistake(part, reason),
        }
    }

    fn size(&mut self, raw: Option<&'a RawValue>) -> Result<[u32; 2], Mistake> {
        let size: [u32; 2] = self.optional(Part::Size, raw)?.unwrap_or(SIZE);
        let usable = size.iter().all(|side| (1..=MAX_SIDE).contains(side));
        if usable { Ok(size) } else { Err(self.mistake(Part::Size, Reason::Size(MAX_SIDE))) }
    }

    /// Reads the materials; answers them with the places of their names in the list.
    fn materials(&mut self, named: Named<'a>) -> Result<(Materials, Names<'a>), Mistake> {
        let (keys, raws): (Vec<_>, Vec<_>) = named.0.into_iter().unzip();
        let materials: Vec<Material> = self.list(Part::Material, &raws)?;
        let mut names = Names::new();
        for (index, (key, material)) in keys.iter().zip(&materials).enumerate() {
            if names.insert(key.0.clone(), index as u16).is_some() {
                let reason = Reason::SameName(key.0.to_string());
                return Err(self.mistake_of_name(&key.0, Part::Material(index), reason));
            }
            if !material.is_painted_once() {
                return Err(self.mistake(Part::Material(index), Reason::Paint));
            }
        }
        let materials = keys.into_iter().map(|key| key.0.into_owned()).zip(materials).collect();
        Ok((materials, names))
    }

    fn objects(&mut self, raws: &[&'a RawValue], names: &Names<'a>) -> Result<Vec<(Shape, u16)>, Mistake> {
        let objects: Vec<Object<'a>> = self.list(Part::Object, raws)?;
        let found = |(index, object): (usize, Object<'a>)| match names.get(&object.material) {
            Some(material) => Ok((object.shape, *material)),
            None => Err(self.unknown_material(index, &object.material, names)),
        };
        objects.into_iter().enumerate().map(found).collect()
    }

    fn unknown_material(&self, object: usize, name: &str, names: &Names<'a>) -> Mistake {
        let mut known: Vec<&str> = names.keys().map(|name| &**name).collect();
        known.sort_unstable();
        let meant = nearest(name, known).map(str::to_owned);
        let reason = Reason::NoSuchMaterial { name: name.to_string(), meant };
        self.mistake_of_name(name, Part::Object(object), reason)
    }
}

/// Holds materials by name, in the file's order.
type Materials = Vec<(String, Material)>;

/// Holds the place of each material in the list.
type Names<'a> = HashMap<Cow<'a, str>, u16>;
