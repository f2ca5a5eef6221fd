//! Settings of a scene file.
//!
//! A field that a file leaves out keeps the value of the core's usual settings. To add one: the field, and
//! a line in each of the two functions.

use super::value::unless;
use crate::rounded::Rounded;
use scanray::output::BLUE_NOISE;
use serde::{Deserialize, Serialize};

/// Is how a picture is made of the scene; its fields are those of the core's settings.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Settings {
    /// How many mirrors light may have met on its way.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub depth: Option<u8>,
    /// Factor on all light before the transfer curve.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exposure: Option<f64>,
    /// How light becomes levels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transfer: Option<Transfer>,
    /// How levels are rounded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dither: Option<Dither>,
}

/// Names a transfer curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Transfer {
    /// The sRGB curve.
    Srgb,
    /// Levels proportional to light.
    Linear,
}

/// Names a way of rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Dither {
    /// Rounds each pixel to the nearest level. (In a file `None` is a field that is left out.)
    Nearest,
    /// Rounds by the thresholds of Bayer's square.
    Ordered,
    /// Rounds by the core's mask of blue noise.
    BlueNoise,
    /// Hands what rounding leaves of a pixel to the next one of its row.
    Diffused,
}

impl Transfer {
    fn in_core(self) -> scanray::Transfer {
        match self {
            Self::Srgb => scanray::Transfer::Srgb,
            Self::Linear => scanray::Transfer::Linear,
        }
    }

    fn of(transfer: scanray::Transfer) -> Self {
        match transfer {
            scanray::Transfer::Srgb => Self::Srgb,
            scanray::Transfer::Linear => Self::Linear,
        }
    }
}

impl Dither {
    fn in_core(self) -> scanray::Dither {
        match self {
            Self::Nearest => scanray::Dither::None,
            Self::Ordered => scanray::Dither::Ordered,
            Self::BlueNoise => scanray::Dither::Mask(&BLUE_NOISE),
            Self::Diffused => scanray::Dither::Diffused,
        }
    }

    fn of(dither: scanray::Dither) -> Self {
        match dither {
            scanray::Dither::None => Self::Nearest,
            scanray::Dither::Ordered => Self::Ordered,
            // For another mask there is no word; whoever says a view sees that it comes back changed.
            scanray::Dither::Mask(_) => Self::BlueNoise,
            scanray::Dither::Diffused => Self::Diffused,
        }
    }
}

impl Settings {
    /// Makes the core's settings, rounded to a number.
    pub fn in_number<S: Rounded>(&self) -> scanray::Settings<S> {
        let mut settings = scanray::Settings::new();
        settings.depth = self.depth.unwrap_or(settings.depth);
        settings.exposure = self.exposure.map_or(settings.exposure, S::round);
        settings.transfer = self.transfer.map_or(settings.transfer, Transfer::in_core);
        settings.dither = self.dither.map_or(settings.dither, Dither::in_core);
        settings
    }

    /// Takes settings of the core, with what differs from the usual ones.
    pub fn of(settings: &scanray::Settings<f64>) -> Self {
        let usual = scanray::Settings::<f64>::new();
        Self {
            depth: unless(usual.depth, settings.depth),
            exposure: unless(usual.exposure, settings.exposure),
            transfer: unless(usual.transfer, settings.transfer).map(Transfer::of),
            dither: unless(usual.dither, settings.dither).map(Dither::of),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scanray::output::Mask;

    static OWN: Mask = [[1 << 14; 16]; 16];

    /// Answers the rounding that comes back from a file.
    fn back(dither: scanray::Dither) -> scanray::Dither {
        Settings::of(&scanray::Settings::new().with_dither(dither)).in_number::<f64>().dither
    }

    #[test]
    fn every_way_of_rounding_comes_back_but_a_mask_of_the_callers_own() {
        use scanray::Dither::{Diffused, Mask, None, Ordered};
        for dither in [None, Ordered, Mask(&BLUE_NOISE), Diffused] {
            assert_eq!(back(dither), dither);
        }
        assert_ne!(back(Mask(&OWN)), Mask(&OWN));
    }
}
