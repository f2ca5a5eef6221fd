//! Where light comes from.

use super::number::{Maker, Triple, number, triple};
use proptest::prelude::*;
use scanray::{Light, Scalar};

#[derive(Clone, Debug)]
pub enum Source {
    Point(Triple),
    Distant(Triple),
    Spot { place: Triple, axis: Triple, cutoff: f64, falloff: u16 },
}

#[derive(Clone, Debug)]
pub struct Lamp {
    pub source: Source,
    color: Triple,
}

pub fn lamp() -> impl Strategy<Value = Lamp> {
    let place = || triple(-8.0, 8.0);
    // Toward somewhere among the things.
    let spot = (place(), triple(-3.0, 3.0), number(0.0, 0.9), 0_u16..20).prop_map(
        |(place, target, cutoff, falloff)| {
            let axis = std::array::from_fn(|i| target[i] - place[i]);
            Source::Spot { place, axis, cutoff, falloff }
        },
    );
    let source = prop_oneof![place().prop_map(Source::Point), place().prop_map(Source::Distant), spot];
    (source, triple(0.0, 1.0)).prop_map(|(source, color)| Lamp { source, color })
}

impl<S: Scalar> Maker<S> {
    pub fn light(&self, lamp: &Lamp) -> Light<S> {
        let color = self.color(lamp.color);
        match lamp.source {
            Source::Point(place) => Light::point(self.vector(place), color),
            Source::Distant(toward) => Light::directional(self.vector(toward), color),
            Source::Spot { place, axis, cutoff, falloff } => {
                Light::spot(self.vector(place), self.vector(axis), self.0(cutoff), falloff, color)
            }
        }
    }
}
