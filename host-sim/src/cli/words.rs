//! The words of the command line for the choices that the rest of the crate knows.

use crate::bake::Accel;
use crate::cost::What;
use crate::dither::Method;
use crate::lessons::Language;
use crate::panel::Panel;
use crate::shot::{Approach, Number, Quality};
use clap::ValueEnum;
use clap::builder::PossibleValue;

impl ValueEnum for Approach {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name()).help(match self {
            Self::Trace => "Rays ask for each pixel what it sees",
            Self::Raster => "A z-buffer asks for each object where it is seen; no shadows, no mirrors",
        }))
    }
}

impl ValueEnum for Quality {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::Exact, Self::Adaptive]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(match self {
            Self::Exact => PossibleValue::new("exact").help("Every pixel is traced"),
            Self::Adaptive => {
                PossibleValue::new("adaptive").help("What lies between pixels that see the same is filled in")
            }
            // Has a number and options of its own.
            Self::Sampled(_) => return None,
        })
    }
}

impl ValueEnum for Number {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name()).help(match self {
            Self::F32 => "The core in f32, for chips with a floating-point unit",
            Self::Fixed => "The core in fixed point, for chips without one",
            Self::Exact => "The core in f64",
            Self::Oracle => "The f64 reference, which shares no code with the core",
        }))
    }
}

impl ValueEnum for What {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name()).help(match self {
            Self::Rays => "Rays of all kinds",
            Self::Shapes => "How often a shape is asked whether a ray meets it",
            Self::Operations => "Sums, products, quotients, roots and powers",
            Self::Instructions => "Instructions that a chip executes; needs `--chip`",
        }))
    }
}

impl ValueEnum for Panel {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name()))
    }
}

impl ValueEnum for Method {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name()).help(match self {
            Self::None => "To the nearest level",
            Self::Ordered => "By Bayer's square of eight",
            Self::BlueNoise => "By a mask of blue noise",
            Self::Diffused => "Handing the error to the right",
        }))
    }
}

impl ValueEnum for Language {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.code()))
    }
}

impl ValueEnum for Accel {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name()).help(match self {
            Self::Bvh => "A tree of boxes",
            Self::Kd => "A tree of planes",
            Self::Octree => "A tree of cubes",
            Self::Grid => "Equal cubes",
            Self::None => "Every thing is asked",
        }))
    }
}
