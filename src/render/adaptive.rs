//! Adaptive rows: some pixels are traced, and what lies between two that saw the same is filled in.
//!
//! The columns between which all pixels have the same candidates are a segment. Its ends are traced,
//! and every eighth column between. Where two neighbours of those disagree, the pixel in their middle
//! is traced, and so on until they agree or touch. Which columns these are depends on the row's number
//! and its segments alone, so that parts of a row come out as the whole does.

use super::Quality;
use super::alike::{are_alike, short};
use super::marks::Marks;
use super::picture::Picture;
use super::workspace::Scratch;
use crate::camera::Row;
use crate::math::Scalar;
use crate::output::{Encode, Rounding, Transfer, light_bits};
use crate::shape::Intersect;
use crate::trace::{Candidates, LANES, Observer, Packet, Tracer};
use core::ops::Range;
use heapless::Vec;

/// Is how far apart pixels are that are always traced.
const STEP: u32 = 8;

/// Is the most columns of a segment in which every pixel is traced.
///
/// The span of an object narrower than a step, rounded outward by up to two columns on either side, is
/// no wider: such an object is never lost.
const NARROW: u32 = 12;

/// Is how many columns one packet of samples reaches.
const REACH: usize = STEP as usize * LANES;

/// Is what a pixel shows and what its ray has seen.
#[derive(Clone, Copy)]
struct Sample {
    levels: [u16; 3],
    /// Where the next sample to the right is, counted from the block's left.
    next: u8,
    /// Whether what lies between here and the next sample may be filled in.
    settled: bool,
    mark: u32,
}

impl Sample {
    const NONE: Self = Self { levels: [0; 3], next: 0, settled: false, mark: 0 };

    /// Tells whether two samples saw the same in about the same colour.
    fn agrees(&self, other: &Self) -> bool {
        self.mark == other.mark && are_alike(&self.levels, &other.levels)
    }
}

/// Holds some samples of a segment, each with the way to the next.
struct Block {
    samples: [Sample; REACH + 1],
    /// The column of the first sample.
    left: u32,
    /// Where the last sample is, counted from the left.
    end: u8,
    /// Where samples are to be taken, from left to right.
    wanted: Vec<u8, LANES>,
}

impl Block {
    fn new() -> Self {
        Self { samples: [Sample::NONE; REACH + 1], left: 0, end: 0, wanted: Vec::new() }
    }

    fn at(&self, place: u8) -> Sample {
        self.samples.get(usize::from(place)).copied().unwrap_or(Sample::NONE)
    }

    fn set(&mut self, place: u8, sample: Sample) {
        if let Some(old) = self.samples.get_mut(usize::from(place)) {
            *old = sample;
        }
    }

    /// Answers the column of a place.
    fn column(&self, place: u8) -> u32 {
        self.left.saturating_add(u32::from(place))
    }

    /// Begins at the first column of a segment.
    fn begin(&mut self, column: u32) {
        (self.left, self.end) = (column, 0);
        let _ = self.wanted.push(0);
    }

    /// Begins where the block before has ended: that sample is taken.
    fn go_on(&mut self) {
        let last = self.at(self.end);
        (self.left, self.end) = (self.column(self.end), 0);
        self.set(0, last);
    }

    /// Wants the columns of a row that are always traced, as many as a packet holds.
    fn want(&mut self, columns: &Columns) {
        while !self.wanted.is_full() && self.column(self.end) < columns.last {
            let place = columns.after(self.column(self.end)).wrapping_sub(self.left) as u8;
            let from = Sample { next: place, settled: false, ..self.at(self.end) };
            self.set(self.end, from);
            self.end = place;
            let _ = self.wanted.push(place);
        }
    }

    /// Wants a pixel between two samples that do not agree, the first ones of those not looked at yet,
    /// as many as a packet holds.
    fn split(&mut self) {
        let mut place = 0;
        while place < self.end && !self.wanted.is_full() {
            let sample = self.at(place);
            let next = sample.next;
            if !sample.settled {
                let settled = next.wrapping_sub(place) < 2 || sample.agrees(&self.at(next));
                let middle = if settled { next } else { place.midpoint(next) };
                self.set(place, Sample { settled, next: middle, ..sample });
                if !settled {
                    self.set(middle, Sample { next, ..Sample::NONE });
                    let _ = self.wanted.push(middle);
                }
            }
            place = next;
        }
    }
}

/// Knows the columns of a segment that are always traced.
struct Columns {
    last: u32,
    /// How far this row's samples are shifted to the left: what a row misses the next may find.
    phase: u32,
    step: u32,
}

impl Columns {
    fn of(segment: Range<u32>, phase: u32) -> Self {
        let step = if segment.len() as u32 <= NARROW { 1 } else { STEP };
        Self { last: segment.end.saturating_sub(1), phase, step }
    }

    /// Answers the next such column.
    fn after(&self, column: u32) -> u32 {
        let shifted = column.saturating_add(self.phase);
        let next = shifted.saturating_sub(shifted % self.step.max(1)).saturating_add(self.step);
        next.saturating_sub(self.phase).min(self.last)
    }
}

/// Takes samples.
struct Probe<'a, 's, 'o, S: Scalar, X, O> {
    tracer: Tracer<'a, 's, S, X>,
    packet: &'s mut Packet<S>,
    marks: Marks<'o, O>,
    transfer: Transfer,
}

impl<S: Scalar, X: Intersect<S>, O: Observer> Probe<'_, '_, '_, S, X, O> {
    /// Takes the samples that a block wants; `row` is not yet past the first.
    fn look<P: Encode>(&mut self, block: &mut Block, row: &mut Row<'_, S>, candidates: Candidates<'_>) {
        let (wanted, left) = (core::mem::take(&mut block.wanted), block.left);
        let rays = wanted.iter().map_while(|place| {
            row.skip_to(left.saturating_add(u32::from(*place)));
            row.next().map(|primary| (primary.ray, primary.interval))
        });
        self.marks.clear();
        let light = self.tracer.radiance(self.packet, rays, candidates, &mut self.marks);
        for ((place, light), mark) in wanted.iter().zip(light).zip(self.marks.marks()) {
            let levels = P::levels(light_bits(*light), self.transfer).map(short);
            let sample = Sample { levels, mark: *mark, ..block.at(*place) };
            block.set(*place, sample);
        }
    }

    /// Takes samples until all neighbours in a block agree or touch.
    fn settle<P: Encode>(&mut self, block: &mut Block, row: &Row<'_, S>, candidates: &Candidates<'_>) {
        loop {
            block.split();
            if block.wanted.is_empty() {
                return;
            }
            self.look::<P>(block, &mut row.clone(), candidates.clone());
        }
    }
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

    /// Writes all columns of a block but the last.
    fn write(&mut self, block: &Block) {
        let mut place = 0;
        while place < block.end {
            let from = block.at(place);
            let count = u32::from(from.next.wrapping_sub(place));
            self.fill(block.column(place), &from, &block.at(from.next), count);
            place = from.next;
        }
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
                probe.settle::<P>(&mut block, &first, &spans.candidates());
                pen.write(&block);
                let reached = block.column(block.end);
                if reached == segment.last || reached >= columns.end {
                    pen.put(reached, block.at(block.end).levels.map(u32::from));
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
