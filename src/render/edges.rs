//! Several rays for pixels on an edge, one for each other pixel (row S3).
//!
//! Rows know nothing of each other, so a row has to find the edges that run along it by itself: its columns
//! are probed in turn at their upper and at their lower end.

use super::Quality;
use super::alike::{are_alike, short};
use super::marks::Marks;
use super::picture::Picture;
use super::samples::Sampler;
use super::workspace::Scratch;
use crate::camera::Row;
use crate::color::Rgb;
use crate::math::{Scalar, WideVec3};
use crate::output::{Transfer, light_bits};
use crate::shape::Intersect;
use crate::trace::{LANES, Observer};
use core::ops::Range;
use heapless::Vec;

/// Is the lines that are probed, by the fraction of the row's height above them.
const LINES: [[u8; 2]; 2] = [[0, 1], [1, 1]];

/// Is what the first ray of a column has seen.
#[derive(Clone, Copy)]
struct Probe<S> {
    light: Rgb<S>,
    levels: [u16; 3],
    mark: u32,
}

impl<S: Scalar> Probe<S> {
    fn agrees(&self, other: &Self) -> bool {
        self.mark == other.mark && are_alike(&self.levels, &other.levels)
    }

    /// Answers the light of a pixel from its probe and those beside it; `None` on an edge, and at the end of
    /// a row, where nobody knows what lies on one side.
    ///
    /// The neighbours' mean is the light at the pixel's other end.
    fn smooth(&self, before: Option<Self>, after: Option<Self>) -> Option<Rgb<S>> {
        let (before, after) = (before?, after?);
        let other_end = (before.light + after.light) * S::HALF;
        (self.agrees(&before) && self.agrees(&after)).then(|| (self.light + other_end) * S::HALF)
    }
}

/// Sends rays through the upper and the lower ends of columns in turn.
struct Zigzag<'s, S: Scalar> {
    row: Row<'s, S>,
    /// From the middle of a pixel to the middles of its upper and its lower side.
    ends: [WideVec3<S>; 2],
    transfer: Transfer,
}

impl<S: Scalar> Zigzag<'_, S> {
    /// Probes some columns of the same candidates, as many as a packet holds.
    ///
    /// Called, not inlined: the probe's tracing is off the stack again before pixels on edges are traced.
    #[inline(never)]
    fn probe<X: Intersect<S>>(
        &mut self,
        sampler: &mut Sampler<'_, '_, '_, S, X, impl Observer>,
        columns: Range<u32>,
    ) -> Vec<Probe<S>, LANES> {
        let Self { row, ends: [upper, lower], transfer } = self;
        let rays = columns.map(|x| {
            row.skip_to(x);
            let primary = row.beside(if x % 2 == 0 { *upper } else { *lower });
            (primary.ray, primary.interval)
        });
        let mut marks = Marks::new(&mut *sampler.observer);
        let candidates = sampler.spans.candidates();
        let taken = sampler.packet.take_up(rays, &candidates, &mut marks);
        let light = sampler.tracer.radiance_of(sampler.packet, taken, candidates, &mut marks);
        let probe = |(light, mark): (&Rgb<S>, &u32)| {
            let levels = light_bits(*light).map(|light| short(transfer.level(light)));
            Probe { light: *light, levels, mark: *mark }
        };
        light.iter().zip(marks.marks()).map(probe).collect()
    }
}

/// Goes along a row and tells pixels on edges from others.
struct Judge<S> {
    /// The columns whose pixels are asked for.
    columns: Range<u32>,
    /// The probes of two neighbours, and the column after them.
    before: Option<Probe<S>>,
    here: Option<Probe<S>>,
    next: u32,
    /// The pixels on an edge that are still to be sampled: those up to here.
    waiting: Range<u32>,
}

impl<S: Scalar> Judge<S> {
    /// Begins with the probe of column `first`, which is to come.
    fn new(columns: Range<u32>, first: u32) -> Self {
        let waiting = columns.start..columns.start;
        Self { columns, before: None, here: None, next: first, waiting }
    }

    /// Takes the probe of the next column, if there is one, and deals with the pixel before it.
    fn go_on<X: Intersect<S>>(
        &mut self,
        after: Option<Probe<S>>,
        sampler: &mut Sampler<'_, '_, '_, S, X, impl Observer>,
        pixel: &mut impl FnMut(u32, Rgb<S>),
    ) {
        let x = self.next.wrapping_sub(1);
        if let Some(here) = self.here.filter(|_| self.columns.contains(&x)) {
            let light = here.smooth(self.before, after);
            self.waiting.end = if light.is_some() { x } else { self.next };
            if let Some(light) = light {
                sampler.trace(self.waiting.clone(), &mut *pixel);
                self.waiting = self.next..self.next;
                pixel(x, light);
            }
        }
        (self.before, self.here, self.next) = (self.here, after, self.next.saturating_add(1));
    }
}

impl<S: Scalar, X: Intersect<S>, Q: Quality> Picture<'_, S, X, Q> {
    /// Traces the pixels `columns` of row `y`, those on edges by several rays, and hands each its linear
    /// light, left to right.
    pub fn sample_edges(
        &self,
        scratch: &mut Scratch<S>,
        y: u32,
        columns: Range<u32>,
        observer: &mut impl Observer,
        mut pixel: impl FnMut(u32, Rgb<S>),
    ) {
        // A pixel is judged beside its neighbours.
        let probed = columns.start.saturating_sub(1)..columns.end.saturating_add(1).min(self.size.width);
        let mut sampler = self.sampler(scratch, [probed.start, y], &LINES, observer);
        let [_, down] = self.frame.pixel();
        let ends = [-S::HALF, S::HALF].map(|half| down.mul_wide(half));
        let mut zigzag = Zigzag { row: sampler.row.clone(), ends, transfer: self.settings.transfer };
        let mut judge = Judge::new(columns, probed.start);
        let mut x = probed.start;
        while x < probed.end {
            let stop = sampler
                .spans
                .enter_column(x)
                .min(probed.end.min(x.saturating_add(LANES as u32)))
                .max(x.saturating_add(1));
            // Moved into a loop, they would lie on the stack twice.
            for probe in &zigzag.probe(&mut sampler, x..stop) {
                judge.go_on(Some(*probe), &mut sampler, &mut pixel);
            }
            x = stop;
        }
        judge.go_on(None, &mut sampler, &mut pixel);
        sampler.trace(judge.waiting, &mut pixel);
    }
}
