//! The samples of an adaptive row that wait to be written, and which are to be taken next.

use super::alike::are_alike;
use crate::trace::LANES;
use core::ops::Range;
use heapless::Vec;

/// Is how far apart pixels are that are always traced.
pub(super) const STEP: u32 = 8;

/// Is the most columns of a segment in which every pixel is traced.
///
/// The span of an object narrower than a step, rounded outward by up to two columns on either side, is
/// no wider: such an object is never lost.
pub(super) const NARROW: u32 = 12;

/// Is how many samples wait at most, 396 bytes.
///
/// Nine begin a block, eight columns apart, and each packet brings up to eight more into the gaps on the
/// left: after the third, gaps halved three times have nothing between them, are written and gone, and
/// sixteen places are free again.
const ROOM: usize = 1 + 4 * LANES;

/// Tells how far a sample is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum State {
    /// It is to be taken.
    Wanted,
    /// It is taken.
    Taken,
    /// What lies between it and the next one may be filled in.
    Settled,
}

/// Is what a pixel shows and what its ray has seen.
#[derive(Clone, Copy)]
pub(super) struct Sample {
    pub levels: [u16; 3],
    /// Where it is, counted from the block's left.
    pub place: u8,
    pub state: State,
    pub mark: u32,
}

impl Sample {
    fn wanted(place: u8) -> Self {
        Self { levels: [0; 3], place, state: State::Wanted, mark: 0 }
    }

    /// Tells whether two samples saw the same in about the same colour.
    fn agrees(&self, next: &Self) -> bool {
        self.mark == next.mark && are_alike(&self.levels, &next.levels)
    }
}

/// Holds some samples of a segment.
pub(super) struct Block {
    /// From left to right.
    pub samples: Vec<Sample, ROOM>,
    /// The column that places are counted from.
    pub left: u32,
}

impl Block {
    pub fn new() -> Self {
        Self { samples: Vec::new(), left: 0 }
    }

    /// Answers the column of a place.
    pub fn column(&self, place: u8) -> u32 {
        self.left.saturating_add(u32::from(place))
    }

    /// Answers the column of the last sample.
    pub fn reached(&self) -> u32 {
        self.column(self.samples.last().map_or(0, |last| last.place))
    }

    /// Begins at the first column of a segment.
    pub fn begin(&mut self, column: u32) {
        self.left = column;
        self.samples.clear();
        let _ = self.samples.push(Sample::wanted(0));
    }

    /// Begins where the block before has ended: that sample is taken, and no other is left.
    pub fn go_on(&mut self) {
        self.left = self.reached();
        if let Some(last) = self.samples.last_mut() {
            last.place = 0;
        }
    }

    /// Wants the columns of a row that are always traced, as many as a packet holds.
    pub fn want(&mut self, columns: &Columns) {
        let first_is_taken = self.samples.first().is_some_and(|first| first.state != State::Wanted);
        let full = LANES + usize::from(first_is_taken);
        while self.samples.len() < full && self.reached() < columns.last {
            let place = columns.after(self.reached()).wrapping_sub(self.left) as u8;
            let _ = self.samples.push(Sample::wanted(place));
        }
    }

    /// Finds the gaps between samples in which nothing more need be taken.
    pub fn judge(&mut self) {
        let mut samples = self.samples.iter_mut();
        let Some(mut sample) = samples.next() else { return };
        for next in samples {
            if next.place.wrapping_sub(sample.place) < 2 || sample.agrees(next) {
                sample.state = State::Settled;
            }
            sample = next;
        }
    }

    /// Wants a pixel in the middle of each gap that is not settled, the first ones, as many as a packet
    /// holds, and tells whether there are any.
    pub fn split(&mut self) -> bool {
        let (mut at, mut wanted) = (0, 0);
        while let Some([sample, next]) = self.samples.get(at..).and_then(|rest| rest.first_chunk()).copied() {
            at = at.saturating_add(1);
            if sample.state != State::Settled {
                if wanted == LANES || self.samples.is_full() {
                    break;
                }
                self.insert(at, Sample::wanted(sample.place.midpoint(next.place)));
                (at, wanted) = (at.saturating_add(1), wanted.saturating_add(1));
            }
        }
        wanted > 0
    }

    /// Lets all samples from a place on make room for one more, which there is.
    fn insert(&mut self, at: usize, sample: Sample) {
        let mut last = sample;
        self.samples.iter_mut().skip(at).for_each(|known| core::mem::swap(known, &mut last));
        let _ = self.samples.push(last);
    }

    /// Forgets the first samples.
    pub fn forget(&mut self, count: usize) {
        for at in count..self.samples.len() {
            let sample = self.samples.get(at).copied();
            if let (Some(place), Some(sample)) = (self.samples.get_mut(at.wrapping_sub(count)), sample) {
                *place = sample;
            }
        }
        self.samples.truncate(self.samples.len().saturating_sub(count));
    }
}

/// Knows the columns of a segment that are always traced.
pub(super) struct Columns {
    pub last: u32,
    /// How far this row's samples are shifted to the left: what a row misses the next may find.
    phase: u32,
    step: u32,
}

impl Columns {
    pub fn of(segment: Range<u32>, phase: u32) -> Self {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Takes all samples of a row of 129 columns as `agree` has it of each two neighbours, and answers the
    /// columns, in the order in which they are written, and the most samples that ever waited.
    fn drawn(agree: impl Fn(u8, u8) -> bool) -> (Vec<u8, 129>, usize) {
        let columns = Columns::of(0..129, 0);
        let (mut block, mut written, mut most) = (Block::new(), Vec::new(), 0);
        block.begin(0);
        loop {
            block.want(&columns);
            loop {
                take(&mut block, &agree);
                most = most.max(block.samples.len());
                block.judge();
                let settled = block.samples.iter().take_while(|sample| sample.state == State::Settled);
                let settled: Vec<u8, 129> = settled.map(|sample| block.column(sample.place) as u8).collect();
                block.forget(settled.len());
                written.extend_from_slice(&settled).expect("no column is written twice");
                if !block.split() {
                    break;
                }
                assert!(is_split_as_far_as_a_packet_goes(&block));
            }
            assert_eq!(block.samples.len(), 1, "all but the last are written");
            if block.reached() == columns.last {
                written.push(columns.last as u8).expect("nor the last one");
                return (written, most);
            }
            block.go_on();
        }
    }

    fn is_split_as_far_as_a_packet_goes(block: &Block) -> bool {
        let is = |sample: &Sample, state| sample.state == state;
        let unsplit = |[a, b]: &[Sample; 2]| is(a, State::Taken) && is(b, State::Taken);
        let wanted = block.samples.iter().filter(|sample| is(sample, State::Wanted)).count();
        wanted == LANES || !block.samples.array_windows().any(unsplit)
    }

    /// Marks samples so that each agrees with the one before it or does not.
    fn take(block: &mut Block, agree: &impl Fn(u8, u8) -> bool) {
        let mut before: Option<Sample> = None;
        for at in 0..block.samples.len() {
            let mut sample = block.samples[at];
            let column = |sample: &Sample| block.column(sample.place) as u8;
            let alike = before.is_some_and(|before| agree(column(&before), column(&sample)));
            let mark = before.map_or(0, |before| if alike { before.mark } else { before.mark + 1 });
            if sample.state != State::Settled {
                sample.state = State::Taken;
            }
            sample.mark = mark;
            block.samples[at] = sample;
            before = Some(sample);
        }
    }

    #[test]
    fn where_no_two_columns_agree_every_one_is_taken_once_from_left_to_right() {
        assert_eq!(drawn(|_, _| false).0, (0..129).collect::<Vec<u8, 129>>());
    }

    #[test]
    fn where_all_agree_every_eighth_is_taken() {
        assert_eq!(drawn(|_, _| true).0, (0..=128).step_by(8).collect::<Vec<u8, 129>>());
    }

    #[test]
    fn whatever_agrees_there_is_room_for_all_that_wait() {
        for seed in 0..if cfg!(miri) { 8 } else { 20_000_u32 } {
            // Of a gap's width and place; how many agree is other from seed to seed, and from width to width.
            let agree = |from: u8, to: u8| {
                let width = u32::from(to - from);
                let random = (seed ^ u32::from(from) << 8 ^ width).wrapping_mul(0x9e37_79b1) >> 24;
                random % 8 < (seed >> width.ilog2()) % 8
            };
            drawn(agree);
        }
        assert_eq!(drawn(|_, _| false).1, ROOM, "no place is idle");
    }
}
