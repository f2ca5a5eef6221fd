use super::Visit;
use super::lattice::Passage;
use crate::math::Scalar;

/// Holds lists of things, one behind the other: what the cells of a hierarchy name.
///
/// Cells that hold the same things share a list, and a thing in several cells is on several lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lists {
    /// Where each list begins among the items, and where the last one ends.
    pub starts: &'static [u32],
    /// Numbers of things.
    pub items: &'static [u16],
}

impl Lists {
    /// Makes lists; see the fields.
    pub const fn new(starts: &'static [u32], items: &'static [u16]) -> Self {
        Self { starts, items }
    }

    /// Answers a list; of one that there is not, an empty one.
    fn list(&self, number: u16) -> &'static [u16] {
        let ends = self.starts.get(usize::from(number)..).and_then(|starts| starts.first_chunk::<2>());
        let range = ends.map(|[first, end]| *first as usize..*end as usize);
        range.and_then(|range| self.items.get(range)).unwrap_or(&[])
    }

    /// Names the things of a list, and moves the far end as it is answered; tells whether the walk goes on.
    pub(super) fn visit<S: Scalar>(
        &self,
        number: u16,
        passage: &mut Passage<S>,
        near: S,
        visit: Visit<'_, S>,
    ) -> bool {
        for item in self.list(number) {
            let far = visit(*item);
            if far <= near {
                return false;
            }
            passage.look_up_to(far);
        }
        true
    }

    /// Tells whether there is a list of this number.
    pub(super) fn has(&self, number: u16) -> bool {
        usize::from(number) + 1 < self.starts.len()
    }

    /// Tells whether the lists take up all items, one after the other, and name only so many things.
    pub(super) fn are_sound(&self, count: u16) -> bool {
        let whole = match (self.starts.first(), self.starts.last()) {
            (Some(first), Some(last)) => *first == 0 && *last as usize == self.items.len(),
            _ => self.items.is_empty(),
        };
        // The standard library's `is_sorted` carries a panic.
        let rising = self.starts.is_sorted_by(|start, end| start <= end);
        whole && rising && self.items.iter().all(|item| *item < count)
    }
}
