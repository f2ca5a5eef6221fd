//! Libraries of materials: MTL files.

use super::survey::{LARGEST, number};
use super::wrong::{Mistake, Reason};
use crate::files::Files;
use crate::model::Paint;
use crate::scene_file::png_file::{self, MAX_TEXELS};
use scanray::{Bitmap, Model};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Is how many materials the libraries of a file may have together.
pub const MAX_MATERIALS: usize = 1 << 16;

/// Holds the materials of a model's libraries.
#[derive(Clone, Debug, Default)]
pub struct Library {
    /// As the reader of the format has them.
    pub materials: Vec<tobj::Material>,
    /// As they are drawn, one for each of these.
    pub paints: Vec<Paint>,
    /// Where the last material of a name is.
    places: HashMap<String, usize>,
    /// The images that have been read, by where they are.
    images: HashMap<PathBuf, Bitmap>,
}

impl Library {
    /// Answers the last material of a name.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.places.get(name).copied()
    }

    /// Takes the materials of a file, and the images that it names.
    ///
    /// # Errors
    /// The first mistake in it, or in an image that it names.
    pub fn read(&mut self, files: &dyn Files, path: &Path, text: &str) -> Result<(), Mistake> {
        let mut checked = String::new();
        let mut begun = self.materials.len();
        for (index, line) in text.lines().enumerate() {
            let line = line.split('#').next().unwrap_or_default().trim();
            begun += usize::from(line.split_whitespace().next() == Some("newmtl"));
            if begun > MAX_MATERIALS {
                return Err(Reason::TooMany { what: "materials", most: MAX_MATERIALS }.at(path, index + 1));
            }
            check(line, &mut checked).map_err(|reason| reason.at(path, index + 1))?;
        }
        let read = tobj::load_mtl_buf(&mut checked.as_bytes());
        let (materials, _) = read.map_err(|error| Reason::Reader(error).of(path))?;
        let folder = path.parent().unwrap_or(Path::new(""));
        for material in materials {
            let image = match &material.diffuse_texture {
                Some(name) => Some(self.image(files, &folder.join(name.replace('\\', "/")))?),
                None => None,
            };
            self.paints.push(paint(&material, image));
            self.places.insert(material.name.clone(), self.materials.len());
            self.materials.push(material);
        }
        Ok(())
    }

    /// Reads an image, but each file only once.
    fn image(&mut self, files: &dyn Files, path: &Path) -> Result<Bitmap, Mistake> {
        let place = files.place(path).map_err(|error| Reason::Io(error).of(path))?;
        if let Some(known) = self.images.get(&place) {
            return Ok(*known);
        }
        let texels = self.images.values().map(Bitmap::size).map(|[columns, rows]| columns * rows);
        let image = png_file::read(files, path, MAX_TEXELS - texels.sum::<u32>());
        let image = image.map_err(|why| Reason::Image(why).of(path))?;
        self.images.insert(place, image);
        Ok(image)
    }
}

/// Keeps a line that says something of what is drawn, with all its numbers.
fn check(line: &str, kept: &mut String) -> Result<(), Reason> {
    let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
    let rest = rest.trim();
    let colors = ["Ka", "Kd", "Ks"];
    let amounts = ["Ns", "Ni", "d", "Tr"];
    if let Some(word) = colors.into_iter().find(|color| *color == word) {
        let numbers: Option<Vec<f64>> = rest.split_whitespace().map(|word| number(word, LARGEST)).collect();
        let [r, g, b] = match numbers.as_deref() {
            Some([grey]) => [*grey; 3],
            Some([r, g, b]) => [*r, *g, *b],
            _ => return Err(Reason::Numbers { word, count: 3, most: LARGEST }),
        };
        *kept += &format!("{word} {r} {g} {b}\n");
    } else if let Some(word) = amounts.into_iter().find(|amount| *amount == word) {
        let amount = rest.split_whitespace().next_back().and_then(|word| number(word, LARGEST));
        let amount = amount.ok_or(Reason::Numbers { word, count: 1, most: LARGEST })?;
        // What one part of the programs calls `Tr`, transparency, others call `d`, what is left of opacity.
        *kept += &if word == "Tr" { format!("d {}\n", 1.0 - amount) } else { format!("{word} {amount}\n") };
    } else if word == "newmtl" {
        if rest.is_empty() {
            return Err(Reason::Name("newmtl"));
        }
        *kept += &format!("newmtl {rest}\n");
    } else if word == "map_Kd" {
        match rest.split_whitespace().next() {
            None => return Err(Reason::Name("map_Kd")),
            Some(option) if option.starts_with('-') => return Err(Reason::MapOption(option.to_owned())),
            Some(_) => *kept += &format!("map_Kd {rest}\n"),
        }
    } else if word == "illum" {
        let model: u8 = rest.parse().map_err(|_| Reason::Numbers { word: "illum", count: 1, most: 255.0 })?;
        *kept += &format!("illum {model}\n");
    }
    Ok(())
}

/// Is the colour of what says none: Blender's grey.
pub const GRAY: [f64; 3] = [0.8; 3];

/// Makes what is drawn of a material.
fn paint(material: &tobj::Material, image: Option<Bitmap>) -> Paint {
    let light = |color: [f64; 3]| color.map(|light| light.clamp(0.0, 1.0));
    let color = light(material.diffuse.unwrap_or(GRAY));
    let mean = |color: [f64; 3]| color.iter().sum::<f64>() / 3.0;
    // The core has a share of the surface's own colour.
    let ambient =
        material.ambient.map_or(1.0, |ambient| (mean(light(ambient)) / mean(color).max(1e-3)).min(1.0));
    let has_highlight = material.illumination_model.is_none_or(|model| model >= 2);
    Paint {
        name: material.name.clone(),
        color,
        image,
        model: if material.illumination_model == Some(0) { Model::Flat } else { Model::Phong },
        ambient,
        specular: if has_highlight { light(material.specular.unwrap_or_default()) } else { [0.0; 3] },
        shininess: material.shininess.unwrap_or(1.0).round().clamp(1.0, 65_535.0) as u16,
        lets_light_through: material.dissolve.is_some_and(|opacity| opacity < 1.0),
    }
}
