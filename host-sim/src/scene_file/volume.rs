//! The volume of a scene file: a body that light comes through.

use super::grid::{Gradient, Grid};
use super::value::{Color, unless};
use crate::rounded::Rounded;
use serde::{Deserialize, Serialize};

/// Is a sampled field with the classes that say what its values look like; its fields are those of the core's
/// volume.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Volume {
    /// The field.
    pub grid: Grid,
    /// What its values look like, by rising value; the tissues of a body if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub classes: Option<Vec<Class>>,
    /// How much light a class of opacity 255 takes away: all but 1/e of it within a length of 1/density.
    pub density: f64,
    /// How the value between voxels is found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reconstruction: Option<Reconstruction>,
    /// How many samples the piece of a ray in one cell takes, at least 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub samples: Option<u8>,
    /// How normals are found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gradient: Option<Gradient>,
    /// Transparency at which a ray ends, 0 to 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub faintest: Option<f64>,
}

/// Is what a value of a voxel means; between two, colour and opacity pass over from one to the other.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Class {
    /// The value.
    pub value: u8,
    /// Colour there.
    pub color: Color,
    /// Opacity there, of 255.
    pub opacity: u8,
}

/// Names how the value between voxels is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Reconstruction {
    /// The value of the nearest voxel.
    Nearest,
    /// The values of the eight voxels around, mixed.
    Trilinear,
}

impl Class {
    fn in_number<S: Rounded>(&self) -> scanray::Class<S> {
        scanray::Class::new(self.value, self.color.in_number(), self.opacity)
    }

    fn of(class: &scanray::Class<f64>) -> Self {
        Self { value: class.value, color: Color::of(class.color), opacity: class.opacity }
    }
}

impl Reconstruction {
    fn in_core(self) -> scanray::Reconstruction {
        match self {
            Self::Nearest => scanray::Reconstruction::Nearest,
            Self::Trilinear => scanray::Reconstruction::Trilinear,
        }
    }

    fn of(reconstruction: scanray::Reconstruction) -> Self {
        match reconstruction {
            scanray::Reconstruction::Nearest => Self::Nearest,
            scanray::Reconstruction::Trilinear => Self::Trilinear,
        }
    }
}

impl Volume {
    /// Makes the core's volume, rounded to a number; its classes stay in memory as long as the program runs.
    pub fn in_number<S: Rounded>(&self) -> scanray::Volume<S> {
        let classes: &'static [scanray::Class<S>] = match &self.classes {
            Some(classes) => classes.iter().map(Class::in_number).collect::<Vec<_>>().leak(),
            None => vec![scanray::Class::TISSUES].leak().as_flattened(),
        };
        let usual = scanray::Volume::new(self.grid.in_number(), classes, S::round(self.density));
        scanray::Volume {
            reconstruction: self.reconstruction.map_or(usual.reconstruction, Reconstruction::in_core),
            samples: self.samples.unwrap_or(usual.samples),
            gradient: self.gradient.map_or(usual.gradient, Gradient::in_core),
            faintest: self.faintest.map_or(usual.faintest, S::round),
            ..usual
        }
    }

    /// Takes a volume of the core, with what differs from its constructor's.
    pub fn of(volume: &scanray::Volume<f64>) -> Self {
        let usual = scanray::Volume::new(volume.grid, volume.classes, volume.density);
        let classes = unless(&scanray::Class::TISSUES[..], volume.classes);
        Self {
            grid: Grid::of(&volume.grid),
            classes: classes.map(|classes| classes.iter().map(Class::of).collect()),
            density: volume.density,
            reconstruction: unless(usual.reconstruction, volume.reconstruction).map(Reconstruction::of),
            samples: unless(usual.samples, volume.samples),
            gradient: unless(usual.gradient, volume.gradient).map(Gradient::of),
            faintest: unless(usual.faintest, volume.faintest),
        }
    }
}
