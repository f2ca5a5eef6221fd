use crate::color::Rgb;
use crate::hit::Surface;
use crate::math::Scalar;
use core::fmt;

/// Is the user's own texture: a function of the place, which answers light from 0 to 1. What it answers
/// beyond is brought to the nearer of the two: no surface sends on more light than it gets.
///
/// ```
/// use scanray::hit::Surface;
/// use scanray::{Material, Procedural, Rgb, Texture};
///
/// fn snow_line(place: &Surface) -> Rgb {
///     if place.point.y > 2.0 { Rgb::WHITE } else { Rgb::new(0.2, 0.3, 0.1) }
/// }
/// static MOUNTAIN: Material = Material::textured(Texture::Custom(Procedural::new(snow_line)));
/// assert_eq!(MOUNTAIN.check(), Ok(()));
/// ```
#[derive(Clone, Copy)]
pub struct Procedural<S = f32>(fn(&Surface<S>) -> Rgb<S>);

impl<S> Procedural<S> {
    /// Makes a texture of a function.
    pub const fn new(color: fn(&Surface<S>) -> Rgb<S>) -> Self {
        Self(color)
    }
}

impl<S: Scalar> Procedural<S> {
    /// Answers the colour at a hit, each part from 0 to 1.
    pub fn color(&self, surface: &Surface<S>) -> Rgb<S> {
        let Rgb { r, g, b } = (self.0)(surface);
        let [r, g, b] = [r, g, b].map(|light| light.max(S::ZERO).min(S::ONE));
        Rgb::new(r, g, b)
    }
}

impl<S> PartialEq for Procedural<S> {
    /// Compares addresses: functions of the same code may count as one.
    fn eq(&self, other: &Self) -> bool {
        core::ptr::fn_addr_eq(self.0, other.0)
    }
}

impl<S> fmt::Debug for Procedural<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Procedural({:p})", self.0 as *const ())
    }
}
