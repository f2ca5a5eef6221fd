use crate::math::Scalar;
use crate::trace::Observer;
use core::ops::Range;

/// Is how many columns are reached by adding, before the line itself is asked again.
///
/// 64 additions in `f32` drift by at most 64 half-steps, 4e-6 of the depth; 64 steps rounded to 2^-20 by
/// 3e-5, of at most 1024.
const BLOCK: u32 = 64;

/// Is what the buffer holds of a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fragment<S> {
    /// How near it is, in the measure of its row's slice.
    pub nearness: S,
    /// Place of the object in the scene's list, or [`Fragment::NOTHING`].
    pub object: u16,
    /// Which part of the object it is.
    pub part: u16,
}

impl<S: Scalar> Fragment<S> {
    /// Stands for no object.
    pub const NOTHING: u16 = u16::MAX;

    /// Is a pixel in which nothing is seen up to a nearness.
    pub const fn empty(nearness: S) -> Self {
        Self { nearness, object: Self::NOTHING, part: 0 }
    }

    /// Takes the place of what is there, if it is nearer; of two equally near the first stays.
    fn cover(&mut self, other: Self) {
        if other.nearness > self.nearness {
            *self = other;
        }
    }
}

/// Answers a number and what comes after it in even steps, without end.
pub(super) fn stepped<S: Scalar>(mut at: S, step: S) -> impl Iterator<Item = S> {
    core::iter::repeat_with(move || {
        let here = at;
        at = at + step;
        here
    })
}

/// Puts one object into a row of depths.
pub(super) struct Painter<'r, S, O> {
    pub row: &'r mut [Fragment<S>],
    pub object: u16,
    pub observer: &'r mut O,
}

impl<S: Scalar, O: Observer> Painter<'_, S, O> {
    /// Puts a part of the object into some columns; `from` answers its nearness from a column on.
    pub fn paint<I: Iterator<Item = S>>(&mut self, columns: Range<u32>, part: u16, from: impl Fn(u32) -> I) {
        if columns.is_empty() {
            return;
        }
        self.observer.span(self.object, &columns);
        let object = self.object;
        let mut first = columns.start;
        while first < columns.end {
            let end = columns.end.min(first.saturating_add(BLOCK));
            let places = self.row.get_mut(first as usize..end as usize).unwrap_or_default();
            for (place, nearness) in places.iter_mut().zip(from(first)) {
                place.cover(Fragment { nearness, object, part });
            }
            first = end;
        }
    }
}
