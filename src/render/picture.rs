use super::Settings;
use super::workspace::Scratch;
use crate::camera::Frame;
use crate::color::Rgb;
use crate::math::Scalar;
use crate::output::{Encode, Quantizer};
use crate::scene::Scene;
use crate::shape::Intersect;
use crate::trace::{Observer, Tracer};
use core::ops::Range;
use embedded_graphics_core::geometry::Size;

/// Is all that says what a picture looks like; it writes only to what it is handed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Picture<'a, S: Scalar, X> {
    pub scene: Scene<'a, S, X>,
    pub frame: Frame<S>,
    pub size: Size,
    pub settings: Settings<S>,
}

impl<S: Scalar, X: Intersect<S>> Picture<'_, S, X> {
    /// Hands each pixel of `columns` in row `y`, a row of the picture, its linear light, left to right.
    pub fn trace_row<const DEPTH: usize>(
        &self,
        scratch: &mut Scratch<S, DEPTH>,
        y: u32,
        columns: Range<u32>,
        observer: &mut impl Observer,
        mut pixel: impl FnMut(u32, Rgb<S>),
    ) {
        let columns = columns.start..columns.end.min(self.size.width);
        let Scratch { waiting, candidates } = scratch;
        candidates.find(&self.scene, &self.frame, y);
        let mut tracer = Tracer::new(&self.scene, waiting, self.settings.depth);
        for (x, primary) in columns.clone().zip(self.frame.row(y, columns.start)) {
            let light = tracer.radiance(&primary.ray, &primary.interval, candidates.iter(), observer);
            pixel(x, light * self.settings.exposure);
        }
    }

    /// Fills `places` with the colours of `columns` in row `y`.
    pub fn encode_row<P: Encode, const DEPTH: usize>(
        &self,
        scratch: &mut Scratch<S, DEPTH>,
        y: u32,
        columns: Range<u32>,
        places: &mut [P],
    ) {
        let Settings { transfer, dither, .. } = self.settings;
        let mut places = places.iter_mut();
        self.trace_row(scratch, y, columns, &mut (), |x, light| {
            if let Some(place) = places.next() {
                *place = P::from_light(light, Quantizer::new(transfer, dither, x, y));
            }
        });
    }
}
