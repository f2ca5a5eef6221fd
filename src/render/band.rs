use super::Spans;
use super::spans::Span;
use crate::camera::Frame;
use crate::math::Scalar;
use crate::scene::Scene;
use crate::shape::Intersect;
use core::ops::Range;

impl Spans {
    /// Finds the columns of each object that any of some lines of row `y` can touch.
    ///
    /// A line is the fraction of the row's height that lies above it, numerator and denominator. Called, not inlined:
    /// what is found once a row is off the stack again before the row is traced.
    #[inline(never)]
    pub(super) fn enter_band<S: Scalar, X: Intersect<S>>(
        &mut self,
        scene: &Scene<'_, S, X>,
        frame: &Frame<S>,
        y: u32,
        lines: impl Iterator<Item = [u8; 2]>,
    ) {
        self.row.clear();
        let Range { start, end } = scene.loose();
        self.rest = end..end;
        let row = u16::try_from(y).unwrap_or(u16::MAX);
        for line in lines {
            let fan = frame.line_fan(y, line);
            let loose = scene.objects.iter().skip(usize::from(start));
            for ((index, object), place) in (start..end).zip(loose).zip(0..) {
                if self.rows.get(place).is_some_and(|rows: &Range<u16>| !rows.contains(&row)) {
                    continue;
                }
                let columns = fan.as_ref().map_or(0..u16::MAX, |fan| fan.columns(&object.shape.hull()));
                if !columns.is_empty() {
                    self.widen(Span { index, columns });
                }
            }
        }
    }

    /// Lets an object be met between more columns.
    fn widen(&mut self, span: Span) {
        let place = match self.row.binary_search_by_key(&span.index, |known| known.index) {
            Ok(place) => {
                if let Some(Span { columns, .. }) = self.row.get_mut(place) {
                    *columns = columns.start.min(span.columns.start)..columns.end.max(span.columns.end);
                }
                return;
            }
            Err(place) => place,
        };
        if span.index >= self.rest.start {
            return;
        }
        // All from its place on make room for it.
        let mut last = span;
        self.row.iter_mut().skip(place).for_each(|known| core::mem::swap(known, &mut last));
        // Objects from `rest` on are candidates everywhere: where there is no more room, the last ones are.
        if let Err(last) = self.row.push(last) {
            self.rest.start = last.index;
        }
    }
}
