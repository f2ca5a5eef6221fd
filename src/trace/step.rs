use super::visibility::Candidates;
use crate::color::Rgb;
use crate::hit::Surface;
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};

/// Is one step of a ray's calculation with the values it works with, as
/// [`Observer::step`](super::Observer::step) is told.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Step<'c, S: Scalar> {
    /// A ray sets out from the eye.
    SetsOut {
        /// Where it starts and where it goes.
        ray: Ray<S>,
        /// Between which distances it looks.
        interval: Interval<S>,
        /// The objects it is asked against, beside those of the scene's hierarchy.
        candidates: Candidates<'c>,
    },
    /// A volume lies on the way of the ray from the eye; all that follows is seen through it.
    Veiled {
        /// Light that the volume itself sends.
        color: Rgb<S>,
        /// Share of the light behind that comes through, from 0 to 1.
        transparency: S,
    },
    /// The ray has met a surface.
    Meets {
        /// How many mirrors and surfaces of glass lie before it.
        level: u8,
        /// Place of the object in the scene's list.
        object: u16,
        /// Distance from where the ray started.
        distance: S,
        /// The place that is lit, with the normal on the viewer's side.
        surface: Surface<S>,
        /// Where the ray has gone, unit length.
        direction: Vec3<S>,
        /// What of the light it brings reaches the eye; the exposure is part of it.
        weight: Rgb<S>,
    },
    /// The ray has met nothing.
    Leaves {
        /// How many mirrors and surfaces of glass lie before the sky.
        level: u8,
        /// Where the ray has gone, unit length.
        direction: Vec3<S>,
        /// What of the light it brings reaches the eye; the exposure is part of it.
        weight: Rgb<S>,
    },
    /// The surface reflects light that comes from everywhere.
    Ambient {
        /// What the surface reflects of white light.
        color: Rgb<S>,
        /// What it sends of the ambient light.
        light: Rgb<S>,
    },
    /// A ray asks whether anything stands between the surface and a light.
    Asks {
        /// Place of the light in the scene's list.
        light: u16,
        /// From the surface toward the light.
        ray: Ray<S>,
        /// How far the light is.
        distance: S,
    },
    /// Nothing does: the light arrives.
    Lit {
        /// Place of the light in the scene's list.
        light: u16,
        /// Light that arrives.
        arriving: Rgb<S>,
        /// Cosine between the normal and the way to the light.
        cosine: S,
        /// Share of it that is reflected diffusely: colour times cosine.
        diffuse: Rgb<S>,
        /// Share of it that the highlight sends to the viewer.
        highlight: Rgb<S>,
        /// What the surface sends of it: what arrives times both shares.
        sent: Rgb<S>,
    },
    /// Surface or sky are done with.
    Sends {
        /// All that they send themselves.
        light: Rgb<S>,
        /// What has reached the eye so far, exposed, of this and all rays before.
        gathered: Rgb<S>,
    },
    /// The ray splits at glass; both weights are as [`Step::Meets`] has them, before what glass on their way absorbs.
    Splits {
        /// Weight of the ray that is reflected.
        reflected: Rgb<S>,
        /// Weight of the ray that is refracted; black where all light turns back.
        refracted: Rgb<S>,
    },
}
