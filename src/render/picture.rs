use super::quality::Way;
use super::workspace::Scratch;
use super::{Quality, Settings};
use crate::camera::Frame;
use crate::color::Rgb;
use crate::math::Scalar;
use crate::output::{Encode, Quantizer};
use crate::scene::Scene;
use crate::shape::Intersect;
use crate::trace::{LANES, Observer, Tracer, Vicinities};
use core::ops::Range;
use embedded_graphics_core::geometry::Size;

/// Is all that says what a picture looks like; it writes only to what it is handed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Picture<'a, S: Scalar, X, Q> {
    pub scene: Scene<'a, S, X>,
    pub frame: Frame<S>,
    pub size: Size,
    pub settings: Settings<S, Q>,
    /// The weight up to which a mirror's light is too faint for any panel.
    pub faintest: S,
}

impl<'a, S: Scalar, X: Intersect<S>, Q: Quality> Picture<'a, S, X, Q> {
    /// Makes the tracer of the picture's rays.
    pub fn tracer<'s>(&'s self, vicinities: &'s mut Vicinities<S>) -> Tracer<'a, 's, S, X> {
        Tracer::new(&self.scene, self.settings.depth)
            .with_exposure(self.settings.exposure)
            .with_eye(self.frame.one_eye())
            .with_faintest(self.faintest)
            .with_vicinities(vicinities)
    }

    /// Traces each pixel of `columns` in row `y`, a row of the picture, and hands it its linear light, left to right.
    pub fn trace_row(
        &self,
        scratch: &mut Scratch<S>,
        y: u32,
        columns: Range<u32>,
        observer: &mut impl Observer,
        mut pixel: impl FnMut(u32, Rgb<S>),
    ) {
        let columns = columns.start..columns.end.min(self.size.width);
        match Q::WAY {
            Way::Sampled => return self.sample_row(scratch, y, columns, observer, pixel),
            Way::SampledAtEdges => return self.sample_edges(scratch, y, columns, observer, pixel),
            Way::Traced | Way::FilledIn => {}
        }
        let Scratch { packet, spans, vicinities } = scratch;
        spans.enter_row(&self.scene, &self.frame, y);
        let mut tracer = self.tracer(vicinities);
        let mut rays = self.frame.row(y, columns.start).map(|primary| (primary.ray, primary.interval));
        let mut x = columns.start;
        while x < columns.end {
            let stop = spans.enter_column(x).clamp(x + 1, columns.end);
            let together = (stop - x).min(LANES as u32);
            let light =
                tracer.radiance(packet, rays.by_ref().take(together as usize), spans.candidates(), observer);
            for light in light {
                pixel(x, *light);
                x += 1;
            }
        }
    }

    /// Fills `places` with the colours of `columns` in row `y`.
    pub fn encode_row<P: Encode>(
        &self,
        scratch: &mut Scratch<S>,
        y: u32,
        columns: Range<u32>,
        places: &mut [P],
        observer: &mut impl Observer,
    ) {
        if Q::WAY == Way::FilledIn {
            return self.fill_row(scratch, y, columns, places, observer);
        }
        let Settings { transfer, dither, .. } = self.settings;
        let thresholds = dither.thresholds(y);
        let mut places = places.iter_mut();
        self.trace_row(scratch, y, columns, observer, |x, light| {
            if let Some(place) = places.next() {
                let threshold = thresholds[x as usize % thresholds.len()];
                *place = P::from_light(light, Quantizer::of_threshold(transfer, threshold));
            }
        });
    }
}
