use crate::camera::Frame;
use crate::math::Scalar;
use crate::scene::Scene;
use crate::shape::Intersect;
use crate::trace::Candidates;
use core::ops::Range;
use heapless::Vec;

/// Is how many objects are known one by one.
const ROOM: usize = 32;

/// Is an object with the columns of the row in which it can be met.
#[derive(Clone, Debug)]
pub(super) struct Span {
    pub index: u16,
    pub columns: Range<u16>,
}

/// Knows which objects the rays of a picture's pixels can meet: none that they meet is missing, but for those
/// in the scene's hierarchy.
///
/// Once a picture it finds the rows that each object can touch, once a row the columns of the
/// objects whose rows these are. Between the ends of such spans all pixels have the same
/// candidates. The first 32 objects that a row touches are known by their columns; what comes
/// after them is a candidate everywhere.
#[derive(Clone, Debug)]
pub struct Spans {
    /// Rows of the first objects; of those that follow the rows are not known.
    pub(super) rows: Vec<Range<u16>, ROOM>,
    /// Objects of the row, in rising order.
    pub(super) row: Vec<Span, ROOM>,
    /// Candidates between two ends.
    here: Vec<u16, ROOM>,
    /// Objects that are candidates in the whole row.
    pub(super) rest: Range<u16>,
}

impl Spans {
    /// Makes the spans of no picture.
    pub const fn new() -> Self {
        Self { rows: Vec::new(), row: Vec::new(), here: Vec::new(), rest: 0..0 }
    }

    /// Finds the rows of each object.
    pub fn enter_picture<S: Scalar, X: Intersect<S>>(&mut self, scene: &Scene<'_, S, X>, frame: &Frame<S>) {
        self.rows.clear();
        let fan = frame.upright_fan();
        for object in scene.objects.iter().skip(usize::from(scene.loose().start)).take(ROOM) {
            let rows = fan.as_ref().map_or(0..u16::MAX, |fan| fan.rows(&object.shape.hull()));
            // There is room for as many as were taken.
            let _ = self.rows.push(rows);
        }
    }

    /// Finds the columns of each object that row `y` can touch.
    pub fn enter_row<S: Scalar, X: Intersect<S>>(
        &mut self,
        scene: &Scene<'_, S, X>,
        frame: &Frame<S>,
        y: u32,
    ) {
        self.row.clear();
        let Range { start, end } = scene.loose();
        self.rest = end..end;
        let fan = frame.row_fan(y);
        let row = u16::try_from(y).unwrap_or(u16::MAX);
        let loose = scene.objects.iter().skip(usize::from(start));
        for ((index, object), place) in (start..end).zip(loose).zip(0..) {
            if self.rows.get(place).is_some_and(|rows: &Range<u16>| !rows.contains(&row)) {
                continue;
            }
            let columns = fan.as_ref().map_or(0..u16::MAX, |fan| fan.columns(&object.shape.hull()));
            if !columns.is_empty() && self.row.push(Span { index, columns }).is_err() {
                self.rest = index..end;
                return;
            }
        }
    }

    /// Finds the candidates of column `x` and answers the next column where they may be others.
    pub fn enter_column(&mut self, x: u32) -> u32 {
        self.here.clear();
        let column = u16::try_from(x).unwrap_or(u16::MAX);
        let mut next = u16::MAX;
        for Span { index, columns } in &self.row {
            if columns.contains(&column) {
                // There is room for as many as the row has.
                let _ = self.here.push(*index);
                next = next.min(columns.end);
            } else if column < columns.start {
                next = next.min(columns.start);
            }
        }
        u32::from(next)
    }

    /// Answers the candidates of the column entered last.
    pub fn candidates(&self) -> Candidates<'_> {
        Candidates { named: &self.here, rest: self.rest.clone() }
    }
}

impl Default for Spans {
    fn default() -> Self {
        Self::new()
    }
}
