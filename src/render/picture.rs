use super::quality::Way;
use super::workspace::Scratch;
use super::{Quality, Settings};
use crate::camera::{Frame, Row};
use crate::color::Rgb;
use crate::math::Scalar;
use crate::output::{Encode, Rounding, light_bits};
use crate::scene::Scene;
use crate::shape::Intersect;
use crate::trace::{Candidates, LANES, Observer, Packet, Pending, RayKind, Tracer, Vicinities};
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
    pub fn tracer<'s>(
        &'s self,
        vicinities: &'s mut Vicinities<S>,
        pending: &'s mut [Pending<S>],
    ) -> Tracer<'a, 's, S, X> {
        let depth = usize::from(self.settings.depth).min(pending.len());
        Tracer::new(&self.scene, pending.split_at_mut(depth).0)
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
        let Scratch { packet, spans, vicinities, pending } = scratch;
        spans.enter_row(&self.scene, &self.frame, y);
        let mut tracer = self.tracer(vicinities, pending);
        let mut row = self.frame.row(y, columns.start);
        let mut x = columns.start;
        while x < columns.end {
            let stop = spans.enter_column(x).min(columns.end).max(x.saturating_add(1));
            let nothing = spans.candidates().is_empty() && self.scene.tree().is_none();
            if let (true, Some(light)) = (nothing, tracer.background()) {
                while x < stop {
                    observer.ray(RayKind::Primary);
                    observer.met(0, u16::MAX, 0);
                    pixel(x, light);
                    x += 1;
                }
                continue;
            }
            row.skip_to(x);
            while x < stop {
                let together = (stop - x).min(LANES as u32);
                let taken = take_up(packet, &mut row, together, &spans.candidates(), observer);
                for light in tracer.radiance_of(packet, taken, spans.candidates(), observer) {
                    pixel(x, *light);
                    // There is a light for each column up to `stop` at most.
                    x = x.wrapping_add(1);
                }
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
        let mut rounding = Rounding::of_row(dither, y);
        let first = columns.start;
        let traced = dither.first_column(first)..columns.end;
        self.trace_row(scratch, y, traced, observer, |x, light| {
            let color = rounding.encode(x, light_bits(light), transfer);
            // Columns left of the first come out beyond the last.
            if let Some(place) = places.get_mut(x.wrapping_sub(first) as usize) {
                *place = color;
            }
        });
    }
}

/// Takes up the rays of some pixels of a row, from left to right, and answers their number.
///
/// Called, not inlined, as is [`Packet::take_up`]; here the row is stepped in registers.
#[inline(never)]
fn take_up<S: Scalar>(
    packet: &mut Packet<S>,
    row: &mut Row<'_, S>,
    count: u32,
    candidates: &Candidates<'_>,
    observer: &mut impl Observer,
) -> usize {
    row.lend(|row| {
        let rays = row.take(count as usize).map(|primary| (primary.ray, primary.interval));
        packet.load(rays, candidates, observer)
    })
}
