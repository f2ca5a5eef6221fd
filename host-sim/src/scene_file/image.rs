//! Images of a scene file: the names of PNG files, and how they lie on what they are for.

use super::png_file::UNREAD;
use super::value::unless;
use crate::rounded::Rounded;
use scanray::Bitmap;
use serde::{Deserialize, Serialize};

/// Is the name of a PNG file, with its texels once they have been read; before, there are none, and the core
/// refuses the image.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "String", into = "String")]
pub struct ImageFile {
    /// Path of the file, from the folder of the scene file if it is relative.
    pub name: String,
    /// The texels.
    pub bitmap: Bitmap,
}

impl From<String> for ImageFile {
    fn from(name: String) -> Self {
        Self { name, bitmap: Bitmap::new(UNREAD) }
    }
}

impl From<ImageFile> for String {
    fn from(file: ImageFile) -> Self {
        file.name
    }
}

impl ImageFile {
    /// Takes an image of the core, which has no name yet.
    pub fn of(bitmap: Bitmap) -> Self {
        Self { name: String::new(), bitmap }
    }
}

/// Is an image over texture coordinates; its fields are those of the core's image of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Image {
    /// The file of the texels.
    pub file: ImageFile,
    /// Copies to a unit of each texture coordinate; below 0 mirrored ones.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub per_unit: Option<[f64; 2]>,
    /// How the colour between texels is found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub filter: Option<Filter>,
}

/// Names how the colour between texels is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Filter {
    /// The colour of the nearest texel.
    Nearest,
    /// The colours of the four texels around, mixed.
    Bilinear,
}

impl Filter {
    /// Makes the core's filter.
    pub fn in_core(self) -> scanray::Filter {
        match self {
            Self::Nearest => scanray::Filter::Nearest,
            Self::Bilinear => scanray::Filter::Bilinear,
        }
    }

    /// Takes a filter of the core.
    pub fn of(filter: scanray::Filter) -> Self {
        match filter {
            scanray::Filter::Nearest => Self::Nearest,
            scanray::Filter::Bilinear => Self::Bilinear,
        }
    }
}

impl Image {
    /// Makes the core's image, rounded to a number.
    pub fn in_number<S: Rounded>(&self) -> scanray::Image<S> {
        let mut image = scanray::Image::new(self.file.bitmap);
        image.per_unit = self.per_unit.map_or(image.per_unit, |counts| counts.map(S::round));
        image.filter = self.filter.map_or(image.filter, Filter::in_core);
        image
    }

    /// Takes an image of the core, with what differs from its constructor's.
    pub fn of(image: &scanray::Image<f64>) -> Self {
        let usual = scanray::Image::new(image.bitmap);
        Self {
            file: ImageFile::of(image.bitmap),
            per_unit: unless(usual.per_unit, image.per_unit),
            filter: unless(usual.filter, image.filter).map(Filter::of),
        }
    }
}
