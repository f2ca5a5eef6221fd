use super::{Cell, Way, step};

/// Walks from cell to cell through their faces, for a line that begins and ends anywhere in its cells (Cohen-Or and
/// Kaufman 1997, "3D Line Voxelization and Connectivity Control"; row V3).
///
/// Where a line leaves a cell is told by its projections onto three planes, beside those of the three edges that
/// meet in the cell's corner ahead: the tripod. In the plane of x and y it is `exy = Dy x - Dx y + cxy`, for the way x
/// and y still to go to the next planes; from the middle of a cell, where both are 1/2, it begins at `(Dy - Dx) / 2`. A
/// step along x adds Dy, one along y takes Dx off, and exz and ezy do likewise: of the three axes the one whose plane
/// comes first is the one that no error rules out. All is counted in steps of 1/256 of a cell.
#[derive(Clone, Debug)]
pub struct Tripod {
    cell: Cell,
    way: Way,
    xy: i64,
    xz: i64,
    zy: i64,
    /// Steps still to come along each axis.
    left: [i64; 3],
    ended: bool,
}

impl Tripod {
    /// Is how many steps a cell is wide.
    pub const STEPS: i32 = 256;

    /// Walks from a point to another, given in steps of 1/256 of a cell; the cells of both are visited. Cell i reaches
    /// from `256 i` to below `256 (i + 1)`.
    pub fn new(from: [i32; 3], to: [i32; 3]) -> Self {
        let way = Way::between(from.map(i64::from), to.map(i64::from));
        let cells = |point: [i32; 3]| point.map(|place| place.div_euclid(Self::STEPS));
        let (cell, end) = (cells(from), cells(to));
        let [dx, dy, dz] = way.length;
        let ahead = |from: i32, rising: bool| {
            let past = i64::from(from.rem_euclid(Self::STEPS));
            if rising { i64::from(Self::STEPS) - past } else { past }
        };
        let [x, y, z] = from;
        let [right, up, back] = way.rising;
        let (x, y, z) = (ahead(x, right), ahead(y, up), ahead(z, back));
        let left = Way::between(cell.map(i64::from), end.map(i64::from)).length;
        Self { cell, way, xy: dy * x - dx * y, xz: dz * x - dx * z, zy: dy * z - dz * y, left, ended: false }
    }

    /// Walks from the middle of one cell to that of another, both within 2^23 cells of the origin.
    pub fn between(from: Cell, to: Cell) -> Self {
        let middle =
            |cell: Cell| cell.map(|place| place.saturating_mul(Self::STEPS).saturating_add(Self::STEPS / 2));
        Self::new(middle(from), middle(to))
    }
}

impl Iterator for Tripod {
    type Item = Cell;

    fn next(&mut self) -> Option<Cell> {
        if self.ended {
            return None;
        }
        let (cell, [x, y, z]) = (self.cell, &mut self.cell);
        let cells = i64::from(Self::STEPS);
        let ([dx, dy, dz], [right, up, back]) =
            (self.way.length.map(|length| length * cells), self.way.rising);
        // A plane in which the line ends may be as near as one that it passes: it is not passed.
        let [goes_x, goes_y, goes_z] = self.left.map(|left| left > 0);
        let [left_x, left_y, left_z] = &mut self.left;
        if goes_x && (!goes_y || self.xy < 0) && (!goes_z || self.xz < 0) {
            step(x, right);
            *left_x -= 1;
            (self.xy, self.xz) = (self.xy + dy, self.xz + dz);
        } else if goes_y && (!goes_z || self.zy >= 0) {
            step(y, up);
            *left_y -= 1;
            (self.xy, self.zy) = (self.xy - dx, self.zy - dz);
        } else if goes_z {
            step(z, back);
            *left_z -= 1;
            (self.xz, self.zy) = (self.xz - dx, self.zy + dy);
        } else {
            self.ended = true;
        }
        Some(cell)
    }
}
