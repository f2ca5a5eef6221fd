//! Glass of a scene file.
//!
//! To add a field: the field, and a line in each of the two functions.

use super::value::{Color, unless};
use crate::rounded::Rounded;
use serde::{Deserialize, Serialize};

/// Is what a surface lets through; its fields are those of the core's glass of the same name.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Glass {
    /// Weight of the light that comes through.
    pub transmission: f64,
    /// Refractive index of the inside.
    pub index: f64,
    /// What of the light turns back at the surface, beside the mirror's weight.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fresnel: Option<Fresnel>,
    /// Share of the light lost in a short way, to a unit of that way.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub absorption: Option<Color>,
}

/// Names the formula for the light that turns back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Fresnel {
    /// Schlick's approximation.
    Schlick,
    /// The mean of both polarisations.
    Exact,
}

impl Fresnel {
    fn of(fresnel: scanray::Fresnel) -> Option<Self> {
        match fresnel {
            scanray::Fresnel::Schlick => Some(Self::Schlick),
            scanray::Fresnel::Exact => Some(Self::Exact),
            _ => None,
        }
    }

    fn in_core(self) -> scanray::Fresnel {
        match self {
            Self::Schlick => scanray::Fresnel::Schlick,
            Self::Exact => scanray::Fresnel::Exact,
        }
    }
}

impl Glass {
    /// Makes the core's glass, rounded to a number.
    pub fn in_number<S: Rounded>(&self) -> scanray::Glass<S> {
        let mut glass = scanray::Glass::new(S::round(self.transmission), S::round(self.index));
        glass.fresnel = self.fresnel.map_or(glass.fresnel, Fresnel::in_core);
        glass.absorption = self.absorption.map_or(glass.absorption, Color::in_number);
        glass
    }

    /// Takes glass of the core, with what differs from its constructor's.
    pub fn of(glass: &scanray::Glass<f64>) -> Self {
        let usual = scanray::Glass::new(glass.transmission, glass.index);
        Self {
            transmission: glass.transmission,
            index: glass.index,
            fresnel: unless(usual.fresnel, glass.fresnel).and_then(Fresnel::of),
            absorption: unless(usual.absorption, glass.absorption).map(Color::of),
        }
    }
}
