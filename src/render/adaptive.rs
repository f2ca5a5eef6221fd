//! Adaptive rows: some pixels are traced, and what lies between two that saw the same is filled in.
//!
//! The columns between which all pixels have the same candidates are a segment. Its ends are traced,
//! and every eighth column between. Where two neighbours of those disagree, the pixel in their middle
//! is traced, and so on until they agree or touch. Which columns these are depends on the row's number
//! and its segments alone, so that parts of a row come out as the whole does.

use super::Quality;
use super::alike::short;
use super::block::{Block, Columns, NARROW, STEP, Sample, State};
use super::marks::Marks;
use super::picture::Picture;
use super::workspace::Scratch;
use crate::camera::Row;
use crate::math::Scalar;
use crate::output::{Encode, Rounding, Transfer, light_bits};
use crate::shape::Intersect;
use crate::trace::{Candidates, Observer, Packet, Tracer};
use core::ops::Range;

/// Takes samples.
struct Probe<'a, 's, 'o, S: Scalar, X, O> {
    tracer: Tracer<'a, 's, S, X>,
    packet: &'s mut Packet<S>,
    marks: Marks<'o, O>,
    transfer: Transfer,
}

impl<S: Scalar, X: Intersect<S>, O: Observer> Probe<'_, '_, '_, S, X, O> {
    /// Takes the samples that a block wants; `row` is not yet past the first.
    #[inline(never)]
    fn look<P: Encode>(&mut self, block: &mut Block, row: &mut Row<'_, S>, candidates: Candidates<'_>) {
        self.marks.clear();
        let taken = take_up(self.packet, row, block, &candidates, &mut self.marks);
        let light = self.tracer.radiance_of(self.packet, taken, candidates, &mut self.marks);
        let wanted = block.samples.iter_mut().filter(|sample| sample.state == State::Wanted);
        for ((sample, light), mark) in wanted.zip(light).zip(self.marks.marks()) {
            let levels = P::levels(light_bits(*light), self.transfer).map(short);
            *sample = Sample { levels, mark: *mark, state: State::Taken, ..*sample };
        }
    }
}

/// Takes up the rays of the samples that a block wants, and answers their number.
///
/// Called, not inlined, as is [`Packet::take_up`]; here the row is stepped in registers.
#[inline(never)]
fn take_up<S: Scalar>(
    packet: &mut Packet<S>,
    row: &mut Row<'_, S>,
    block: &Block,
    candidates: &Candidates<'_>,
    observer: &mut impl Observer,
) -> usize {
    let wanted = block.samples.iter().filter(|sample| sample.state == State::Wanted);
    row.lend(|row| {
        let rays = wanted.map_while(|sample| {
            row.skip_to(block.column(sample.place));
            row.next().map(|primary| (primary.ray, primary.interval))
        });
        packet.load(rays, candidates, observer)
    })
}

/// Writes the pixels of a row.
struct Pen<'p, P> {
    places: &'p mut [P],
    /// The column of the first place.
    first: u32,
    rounding: Rounding,
}

impl<P: Encode> Pen<'_, P> {
    fn put(&mut self, x: u32, levels: [u32; 3]) {
        let color = self.rounding.round(x, levels);
        // Columns left of the first come out beyond the last.
        if let Some(place) = self.places.get_mut(x.wrapping_sub(self.first) as usize) {
            *place = color;
        }
    }

    /// Fills in from a sample to the pixel before the next.
    fn fill(&mut self, x: u32, from: &Sample, to: &Sample, count: u32) {
        // Levels of 16 bits with 14 more: their sums fit 31.
        const BITS: u32 = 14;
        const SHARES: [i32; STEP as usize + 1] = shares();
        let share = SHARES.get(count as usize).copied().unwrap_or(0);
        let mut levels = from.levels.map(|level| i32::from(level) << BITS | 1 << (BITS - 1));
        let mut steps = [0; 3];
        for (step, (from, to)) in steps.iter_mut().zip(from.levels.iter().zip(&to.levels)) {
            // At most `ALIKE` apart, unless there is nothing between.
            let rise = i32::from(*to) - i32::from(*from);
            *step = if count > 1 { rise.wrapping_mul(share) } else { 0 };
        }
        for x in x..x.saturating_add(count) {
            self.put(x, levels.map(|level| (level >> BITS) as u32));
            for (level, step) in levels.iter_mut().zip(steps) {
                *level = level.wrapping_add(step);
            }
        }
    }

    /// Writes the columns of a block up to the first gap in which more has to be seen, and tells whether
    /// there is one: the block then wants it. What is written is forgotten.
    ///
    /// Called, not inlined: what writing takes is off the stack before the next ray is traced.
    #[inline(never)]
    fn write(&mut self, block: &mut Block) -> bool {
        block.judge();
        let mut written = 0_usize;
        for (sample, next) in block.samples.iter().zip(block.samples.iter().skip(1)) {
            if sample.state != State::Settled {
                break;
            }
            let count = u32::from(next.place.wrapping_sub(sample.place));
            self.fill(block.column(sample.place), sample, next, count);
            written = written.saturating_add(1);
        }
        block.forget(written);
        block.split()
    }
}

impl<S: Scalar, X: Intersect<S>, Q: Quality> Picture<'_, S, X, Q> {
    /// Fills `places` with the colours of `columns` in row `y`.
    pub(super) fn fill_row<P: Encode>(
        &self,
        scratch: &mut Scratch<S>,
        y: u32,
        columns: Range<u32>,
        places: &mut [P],
        observer: &mut impl Observer,
    ) {
        let Scratch { packet, spans, vicinities, pending } = scratch;
        let tracer = self.tracer(vicinities, pending);
        let marks = Marks::new(observer);
        let mut probe = Probe { tracer, packet, marks, transfer: self.settings.transfer };
        let mut pen =
            Pen { places, first: columns.start, rounding: Rounding::of_row(self.settings.dither, y) };
        let mut block = Block::new();
        let phase = y % 2 * (STEP / 2);
        // A segment cut here, before the first column, is wide with or without what is cut off.
        let first = self.settings.dither.first_column(columns.start);
        let mut x = first.saturating_sub(NARROW).saturating_add(phase) / STEP * STEP;
        x = x.saturating_sub(phase);
        spans.enter_row(&self.scene, &self.frame, y);
        let mut row = self.frame.row(y, x);
        while x < columns.end {
            let stop = spans.enter_column(x).min(self.size.width).max(x.saturating_add(1));
            let segment = Columns::of(x..stop, phase);
            block.begin(x);
            loop {
                let first = row.clone();
                block.want(&segment);
                probe.look::<P>(&mut block, &mut row, spans.candidates());
                while pen.write(&mut block) {
                    probe.look::<P>(&mut block, &mut first.clone(), spans.candidates());
                }
                let reached = block.reached();
                if reached == segment.last || reached >= columns.end {
                    let levels = block.samples.last().map_or([0; 3], |last| last.levels);
                    pen.put(reached, levels.map(u32::from));
                    break;
                }
                block.go_on();
            }
            x = stop;
        }
    }
}

/// Answers 2^14 divided by each number up to a step, rounded down.
const fn shares() -> [i32; STEP as usize + 1] {
    let mut shares = [0; STEP as usize + 1];
    let mut count = 1;
    while count < shares.len() {
        shares[count] = (1 << 14) / count as i32;
        count += 1;
    }
    shares
}
