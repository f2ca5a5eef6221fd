use super::{Spectrum, WHITE, X_BAR, Y_BAR, Z_BAR};
use crate::color::Rgb;
use crate::math::Fixed;

/// Is a colour as the CIE 1931 observer sees it, in percent: what reflects all of its lamp has a `y` of 100.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Xyz {
    /// How much the long wavelengths excite the observer.
    pub x: f64,
    /// Luminance.
    pub y: f64,
    /// How much the short wavelengths excite the observer.
    pub z: f64,
}

/// Is where the sums begin and end, and how far apart their wavelengths are, in nanometres.
const FIRST: u16 = 380;
const LAST: u16 = 780;
const STEP: u16 = 5;

/// Takes linear sRGB from XYZ whose white has a Y of 1 (IEC 61966-2-1:1999).
const SRGB: [[f64; 3]; 3] =
    [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]];

impl Spectrum {
    /// Answers the colour of a surface that reflects this share of each wavelength of a lamp (row X1).
    ///
    /// The sums run from 380 to 780 nm in steps of 5: the illuminants come out within 0.01 of what the CIE
    /// finds in steps of 1. It takes some 3000 operations in `f64`: let it be a constant.
    pub const fn under(&self, lamp: &Self) -> Xyz {
        let (mut sums, mut white) = (Xyz { x: 0.0, y: 0.0, z: 0.0 }, 0.0);
        let mut nm = FIRST;
        while nm <= LAST {
            let power = lamp.at(nm);
            let light = self.at(nm) * power;
            sums.x += light * X_BAR.at(nm);
            sums.y += light * Y_BAR.at(nm);
            sums.z += light * Z_BAR.at(nm);
            white += power * Y_BAR.at(nm);
            nm += STEP;
        }
        // Without a lamp everything is black.
        sums.scaled(if white > 0.0 { 100.0 / white } else { 0.0 })
    }

    /// Answers the colour of a lamp, as white paper shows it.
    pub const fn of_lamp(&self) -> Xyz {
        WHITE.under(self)
    }
}

impl Xyz {
    /// Answers the colour under more or less of the same light.
    pub const fn scaled(self, factor: f64) -> Self {
        Self { x: factor * self.x, y: factor * self.y, z: factor * self.z }
    }

    /// Answers red, green and blue light (row X2); below 0 where the primaries cannot make the colour.
    ///
    /// White under [`D65`](super::D65) is 1, 1 and 1 within 2e-4.
    pub const fn linear_srgb(self) -> [f64; 3] {
        let [red, green, blue] = SRGB;
        [self.along(red), self.along(green), self.along(blue)]
    }

    const fn along(self, [x, y, z]: [f64; 3]) -> f64 {
        (x * self.x + y * self.y + z * self.z) / 100.0
    }

    /// Answers red, green and blue light; none where there would be less than none.
    const fn lights(self) -> [f64; 3] {
        let [r, g, b] = self.linear_srgb();
        [r.max(0.0), g.max(0.0), b.max(0.0)]
    }
}

impl Rgb<f32> {
    /// Makes the light of a colour; a primary that would be below 0 is left out.
    pub const fn from_xyz(xyz: Xyz) -> Self {
        let [r, g, b] = xyz.lights();
        Self::new(r as f32, g as f32, b as f32)
    }
}

impl Rgb<Fixed> {
    /// Makes the light of a colour; a primary that would be below 0 is left out.
    pub const fn from_xyz(xyz: Xyz) -> Self {
        let [r, g, b] = xyz.lights();
        Self::from_f64(r, g, b)
    }
}

impl Rgb<f64> {
    /// Makes the light of a colour; a primary that would be below 0 is left out.
    pub const fn from_xyz(xyz: Xyz) -> Self {
        let [r, g, b] = xyz.lights();
        Self::new(r, g, b)
    }
}
