use super::{Cell, Way, step};

/// Walks from cell to cell along the longest axis, one step at a time, and along the others where the line is
/// nearer to the next row of cells (Bresenham 1965, in three dimensions; row V3).
///
/// With D the steps along the longest axis and d those along another, that one's error `e` begins at `2 d - D` and
/// grows by `2 d` a step; where it is positive the walk goes aside and the error falls by `2 D`. Neighbours share at
/// least a corner: the walk is 26-connected and leaves out cells that the line goes through.
#[derive(Clone, Debug)]
pub struct Bresenham {
    cell: Cell,
    way: Way,
    /// Steps along the longest axis.
    longest: i64,
    error: [i64; 3],
    /// Cells still to come.
    left: i64,
}

impl Bresenham {
    /// Walks from the middle of one cell to that of another, both visited.
    pub fn new(from: Cell, to: Cell) -> Self {
        let way = Way::between(from.map(i64::from), to.map(i64::from));
        let [x, y, z] = way.length;
        let longest = x.max(y).max(z);
        Self {
            cell: from,
            way,
            longest,
            error: way.length.map(|length| 2 * length - longest),
            left: longest + 1,
        }
    }
}

impl Iterator for Bresenham {
    type Item = Cell;

    fn next(&mut self) -> Option<Cell> {
        if self.left == 0 {
            return None;
        }
        self.left -= 1;
        let cell = self.cell;
        let axes = self.cell.iter_mut().zip(&mut self.error).zip(self.way.length).zip(self.way.rising);
        for (((place, error), length), rising) in axes {
            // On the longest axis the error is D and stays so.
            if *error > 0 {
                step(place, rising);
                *error -= 2 * self.longest;
            }
            *error += 2 * length;
        }
        Some(cell)
    }
}
