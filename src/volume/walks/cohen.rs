use super::{Cell, Way, step};

/// Walks from cell to cell through their faces, by three differences (D. Cohen 1994, "Voxel Traversal along a 3D
/// Line", in *Graphics Gems IV*; row V3).
///
/// For a line of Dx, Dy and Dz steps between the middles of two cells, `exy = Dy - Dx`, `exz = Dz - Dx` and
/// `ezy = Dy - Dz` tell of each two axes which plane comes first: below 0 it is that of the first. A step along x
/// adds `2 Dy` to exy and `2 Dz` to exz; one along y takes `2 Dx` off exy and `2 Dz` off ezy; one along z takes `2 Dx`
/// off exz and adds `2 Dy` to ezy. The walk is 6-connected and visits every cell that the line goes through.
#[derive(Clone, Debug)]
pub struct Cohen {
    cell: Cell,
    way: Way,
    xy: i64,
    xz: i64,
    zy: i64,
    /// Cells still to come.
    left: i64,
}

impl Cohen {
    /// Walks from the middle of one cell to that of another, both visited.
    pub fn new(from: Cell, to: Cell) -> Self {
        let way = Way::between(from.map(i64::from), to.map(i64::from));
        let [x, y, z] = way.length;
        Self { cell: from, way, xy: y - x, xz: z - x, zy: y - z, left: x + y + z + 1 }
    }
}

impl Iterator for Cohen {
    type Item = Cell;

    fn next(&mut self) -> Option<Cell> {
        if self.left == 0 {
            return None;
        }
        self.left -= 1;
        let cell = self.cell;
        let ([dx, dy, dz], [right, up, back]) = (self.way.length.map(|length| 2 * length), self.way.rising);
        let [x, y, z] = &mut self.cell;
        if self.xy < 0 && self.xz < 0 {
            step(x, right);
            (self.xy, self.xz) = (self.xy + dy, self.xz + dz);
        } else if self.xy >= 0 && self.zy >= 0 {
            step(y, up);
            (self.xy, self.zy) = (self.xy - dx, self.zy - dz);
        } else {
            step(z, back);
            (self.xz, self.zy) = (self.xz - dx, self.zy + dy);
        }
        Some(cell)
    }
}
