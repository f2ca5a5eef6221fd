//! Several rays a pixel, averaged in linear light (row S1).

use super::pattern::Pattern;
use super::picture::Picture;
use super::workspace::Scratch;
use super::{Quality, Spans};
use crate::camera::{Row, RowRay};
use crate::color::Rgb;
use crate::math::{Scalar, Vec3, Wide};
use crate::shape::Intersect;
use crate::trace::{LANES, Observer, Packet, Tracer};
use core::convert::Infallible;
use core::ops::Range;

/// Traces pixels of a row, each by all rays of a pattern.
pub(super) struct Sampler<'a, 's, 'o, S: Scalar, X, O> {
    pub tracer: Tracer<'a, 's, S, X>,
    pub packet: &'s mut Packet<S>,
    pub spans: &'s mut Spans,
    pub observer: &'o mut O,
    /// The rays of the row, up to the column that was sampled last.
    pub row: Row<'s, S>,
    grid: Grid<S>,
}

impl<'a, S: Scalar, X: Intersect<S>, Q: Quality> Picture<'a, S, X, Q> {
    /// Makes the sampler of row `y` from column `x` on.
    ///
    /// Its candidates are those of the pattern's lines and of `more`, each a fraction of the row's height. Called, not
    /// inlined: what is made once a row is off the stack again before the row is traced.
    #[inline(never)]
    pub fn sampler<'s, 'o, O: Observer>(
        &'s self,
        scratch: &'s mut Scratch<S>,
        [x, y]: [u32; 2],
        more: &[[u8; 2]],
        observer: &'o mut O,
    ) -> Sampler<'a, 's, 'o, S, X, O> {
        let Scratch { packet, spans, vicinities, pending } = scratch;
        let pattern = self.settings.quality.pattern();
        let lines = (0..pattern.lines())
            .map(|line| [line.saturating_mul(2).saturating_add(1), pattern.lines().saturating_mul(2)]);
        spans.enter_band(&self.scene, &self.frame, y, lines.chain(more.iter().copied()));
        let (tracer, row) = (self.tracer(vicinities, pending), self.frame.row(y, x));
        let grid = Grid::new(pattern, self.frame.pixel(), y);
        Sampler { tracer, packet, spans, observer, row, grid }
    }

    /// Traces each pixel of `columns` in row `y` by several rays and hands it its linear light, left to
    /// right.
    pub fn sample_row(
        &self,
        scratch: &mut Scratch<S>,
        y: u32,
        columns: Range<u32>,
        observer: &mut impl Observer,
        pixel: impl FnMut(u32, Rgb<S>),
    ) {
        let mut sampler = self.sampler(scratch, [columns.start, y], &[], observer);
        sampler.trace(columns, pixel);
    }
}

impl<S: Scalar, X: Intersect<S>, O: Observer> Sampler<'_, '_, '_, S, X, O> {
    /// Traces pixels from left to right and hands each its light.
    pub fn trace(&mut self, columns: Range<u32>, mut pixel: impl FnMut(u32, Rgb<S>)) {
        let Ok(()) = self.try_trace(columns, 1, |x, light| {
            pixel(x, light);
            Ok::<(), Infallible>(())
        });
    }

    /// Traces every so many-th of some pixels, the first one first, until one is refused.
    ///
    /// Columns left of those traced before are not gone back to. Called, not inlined: pixels on edges come here from
    /// two places.
    #[inline(never)]
    pub fn try_trace<E>(
        &mut self,
        columns: Range<u32>,
        stride: u32,
        mut pixel: impl FnMut(u32, Rgb<S>) -> Result<(), E>,
    ) -> Result<(), E> {
        let Self { tracer, packet, spans, observer, row, grid } = self;
        let mut next = Sample { x: columns.start, number: 0 };
        let mut mean = Mean::new(grid.pattern.count());
        while next.x < columns.end {
            let stop = spans.enter_column(next.x).min(columns.end).max(next.x.saturating_add(1));
            while next.x < stop {
                let mut sample = next;
                let rays = (0..LANES).map_while(|_| {
                    let here = Some(next).filter(|next| next.x < stop)?;
                    next = grid.after(here, stride);
                    row.skip_to(here.x);
                    let primary = grid.ray(row, here);
                    Some((primary.ray, primary.interval))
                });
                for light in tracer.radiance(packet, rays, spans.candidates(), *observer) {
                    mean.add(sample.number, *light);
                    let after = grid.after(sample, stride);
                    if after.number == 0 {
                        pixel(sample.x, mean.light())?;
                    }
                    sample = after;
                }
                next = sample;
            }
        }
        Ok(())
    }
}

/// Is one of a pixel's rays.
#[derive(Clone, Copy)]
struct Sample {
    x: u32,
    number: u32,
}

/// Knows where in a row's pixels the rays of a pattern go.
struct Grid<S> {
    pattern: Pattern,
    y: u32,
    /// The sides of a pixel, to the right and downward.
    sides: [Vec3<S>; 2],
    /// Half the distance of two places, as a share of the pixel's side.
    half: S,
}

impl<S: Scalar> Grid<S> {
    fn new(pattern: Pattern, sides: [Vec3<S>; 2], y: u32) -> Self {
        let half = S::ONE.ratio(S::from_i32(2 * i32::from(pattern.lines())));
        Self { pattern, y, sides, half }
    }

    /// Answers the sample after this one, among pixels `stride` apart.
    fn after(&self, Sample { x, number }: Sample, stride: u32) -> Sample {
        let next = number.wrapping_add(1);
        if next < self.pattern.count() {
            Sample { x, number: next }
        } else {
            Sample { x: x.saturating_add(stride), number: 0 }
        }
    }

    fn ray(&self, row: &Row<'_, S>, Sample { x, number }: Sample) -> RowRay<S> {
        if self.pattern == Pattern::MIDDLE {
            return row.here();
        }
        let [right, down] = self
            .pattern
            .place([x, self.y], number)
            .map(|place| S::from_i32(2 * i32::from(place) + 1 - i32::from(self.pattern.lines())) * self.half);
        row.beside(self.sides[0].mul_wide(right) + self.sides[1].mul_wide(down))
    }
}

/// Averages light around the first sample: equal ones come out to the bit, whatever their number.
struct Mean<S: Scalar> {
    first: Rgb<S>,
    /// How much the others are above the first, all together: wide, for bright ones would saturate.
    above: [S::Wide; 3],
    count: i32,
}

impl<S: Scalar> Mean<S> {
    fn new(count: u32) -> Self {
        Self { first: Rgb::BLACK, above: [S::Wide::ZERO; 3], count: count as i32 }
    }

    fn add(&mut self, number: u32, light: Rgb<S>) {
        if number == 0 {
            (self.first, self.above) = (light, [S::Wide::ZERO; 3]);
        } else {
            let first = self.first;
            let differences = [light.r - first.r, light.g - first.g, light.b - first.b];
            for (above, difference) in self.above.iter_mut().zip(differences) {
                *above = *above + difference.mul_wide(S::ONE);
            }
        }
    }

    fn light(&self) -> Rgb<S> {
        let [r, g, b] = self.above.map(|above| S::narrow(above.scale(1, self.count)));
        self.first + Rgb::new(r, g, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Fixed;

    #[test]
    fn one_blinding_sample_among_dark_ones_does_not_saturate_the_mean() {
        let mut mean = Mean::<Fixed>::new(64);
        (0..64).for_each(|n| mean.add(n, if n == 0 { Rgb::gray(Fixed::new(960.0)) } else { Rgb::BLACK }));
        assert!((mean.light().r.to_f64() - 15.0).abs() < 1e-4, "{:?}", mean.light());
    }
}
