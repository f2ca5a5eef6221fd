//! Light at glass, by angles: the lecture's `sin t = (ni / nt) sin i` and Fresnel's laws of sines and tangents.

use super::vector::Vector;

/// Is what a material lets through.
#[derive(Clone, Copy, Debug)]
pub(super) struct Glass {
    pub transmission: f64,
    pub index: f64,
    pub turning: Turning,
    pub absorption: Vector,
}

/// Names the formula for the light that turns back.
#[derive(Clone, Copy, Debug)]
pub(super) enum Turning {
    Nothing,
    Schlick,
    Fresnel,
}

/// Is what becomes of a ray at a surface of glass.
pub(super) struct Split {
    /// Where the light goes that gets through.
    pub through: Option<Vector>,
    /// Share of the transmitted light that turns back.
    pub turned: f64,
}

impl Glass {
    /// Answers what light is left after a way through the inside.
    pub fn left_after(&self, way: f64) -> Vector {
        Vector::by_axis(|channel| (-self.absorption.0[channel] * way).exp())
    }

    /// Splits a ray of unit direction at a unit normal on its side, between the indices `from` and `to`.
    pub fn split(&self, direction: Vector, normal: Vector, [from, to]: [f64; 2]) -> Split {
        let along = direction + normal * -normal.inner(direction);
        let incidence = along.inner(along).sqrt().min(1.0).asin();
        let sine = from / to * incidence.sin();
        if sine > 1.0 {
            return Split { through: None, turned: 1.0 };
        }
        let refraction = sine.asin();
        let sideways = if incidence > 0.0 { along.unit() } else { along };
        let through = sideways * sine + normal * -refraction.cos();
        let straight = ((from - to) / (from + to)).powi(2);
        let turned = match self.turning {
            Turning::Nothing => 0.0,
            Turning::Schlick => straight + (1.0 - straight) * (1.0 - incidence.max(refraction).cos()).powi(5),
            // Both laws are 0 / 0 straight on, and 1e-12 off this limit here.
            Turning::Fresnel if incidence < 1e-6 => straight,
            Turning::Fresnel => {
                let (difference, sum) = (incidence - refraction, incidence + refraction);
                ((difference.sin() / sum.sin()).powi(2) + (difference.tan() / sum.tan()).powi(2)) / 2.0
            }
        };
        Split { through: Some(through), turned }
    }
}
