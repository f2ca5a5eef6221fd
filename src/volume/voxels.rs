use core::{fmt, ptr};

/// Is the values of a grid of voxels, 8 bits each, as they lie in flash: x runs fastest, then y, then z.
///
/// Two are equal if they are the same bytes in the same place. With blocks (see [`Voxels::with_blocks`])
/// rays leave out what they cannot see, and the picture is the same to the bit.
#[derive(Clone, Copy)]
pub struct Voxels {
    sides: [u16; 3],
    values: &'static [u8],
    blocks: Option<&'static [u8]>,
}

impl Voxels {
    /// Is the most voxels along a side.
    pub const LARGEST: u16 = 1024;

    /// Is how many cells a block has along a side.
    pub const BLOCK: u16 = 4;

    /// Names the values of a grid of so many voxels along x, y and z.
    pub const fn new(sides: [u16; 3], values: &'static [u8]) -> Self {
        Self { sides, values, blocks: None }
    }

    /// Adds the smallest and the largest value of each block of 4 x 4 x 4 cells, two bytes a block in the order of
    /// the voxels: what [`Voxels::extremes`] answers, baked. 1/32 of the values' bytes.
    pub const fn with_blocks(mut self, blocks: &'static [u8]) -> Self {
        self.blocks = Some(blocks);
        self
    }

    /// Answers how many voxels there are along x, y and z.
    pub const fn sides(&self) -> [u16; 3] {
        self.sides
    }

    /// Answers how many blocks there are along x, y and z.
    pub fn block_sides(&self) -> [u16; 3] {
        self.sides.map(|side| side.saturating_sub(1).div_ceil(Self::BLOCK))
    }

    /// Answers the value of a voxel; outside the grid any.
    #[inline]
    pub fn value(&self, voxel: [u16; 3]) -> u8 {
        self.values.get(index(self.sides, voxel)).copied().unwrap_or(0)
    }

    /// Answers the smallest and the largest value at the corners of some cells, from one to another.
    fn range(&self, first: [u16; 3], last: [u16; 3]) -> [u8; 2] {
        let mut range = [u8::MAX, 0];
        for z in first[2]..=last[2].saturating_add(1) {
            for y in first[1]..=last[1].saturating_add(1) {
                for x in first[0]..=last[0].saturating_add(1) {
                    let value = self.value([x, y, z]);
                    range = [range[0].min(value), range[1].max(value)];
                }
            }
        }
        range
    }

    /// Works out the smallest and the largest value at the corners of a block's cells.
    pub fn extremes(&self, block: [u16; 3]) -> [u8; 2] {
        let first = block.map(|place| place.saturating_mul(Self::BLOCK));
        let mut last = first;
        for (last, side) in last.iter_mut().zip(self.sides) {
            *last = last.saturating_add(Self::BLOCK - 1).min(side.saturating_sub(2));
        }
        self.range(first, last)
    }

    /// Answers the smallest and the largest value at the corners of a cell. Called, not inlined: its
    /// registers are not on the stack below a surface's search.
    #[inline(never)]
    pub(crate) fn of_cell(&self, cell: [u16; 3]) -> [u8; 2] {
        self.range(cell, cell)
    }

    /// Answers the smallest and the largest value of the block that holds a cell, if blocks are baked.
    #[inline]
    pub(crate) fn of_block(&self, cell: [u16; 3]) -> Option<[u8; 2]> {
        let block = cell.map(|place| place / Self::BLOCK);
        let first = index(self.block_sides(), block).saturating_mul(2);
        let bytes = self.blocks?.get(first..first.saturating_add(2))?;
        bytes.try_into().ok()
    }

    /// Tells whether every side has 2 to [`Voxels::LARGEST`] voxels, and there are as many bytes as that takes.
    pub fn fits(&self) -> bool {
        let count = |sides: [u16; 3]| sides.iter().map(|side| usize::from(*side)).product::<usize>();
        self.sides.iter().all(|side| (2..=Self::LARGEST).contains(side))
            && self.values.len() == count(self.sides)
            && self.blocks.is_none_or(|blocks| blocks.len() == 2 * count(self.block_sides()))
    }
}

/// Answers the place of a voxel among those of a grid.
fn index([columns, rows, _]: [u16; 3], [x, y, z]: [u16; 3]) -> usize {
    // 1024^3 fits 32 bits, and what lies outside finds no value.
    let [columns, rows, x, y, z] = [columns, rows, x, y, z].map(usize::from);
    z.saturating_mul(rows).saturating_add(y).saturating_mul(columns).saturating_add(x)
}

impl PartialEq for Voxels {
    fn eq(&self, other: &Self) -> bool {
        let same = |a: Option<&[u8]>, b: Option<&[u8]>| match (a, b) {
            (Some(a), Some(b)) => ptr::eq(a, b),
            (a, b) => a.is_none() && b.is_none(),
        };
        self.sides == other.sides && ptr::eq(self.values, other.values) && same(self.blocks, other.blocks)
    }
}

impl fmt::Debug for Voxels {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.sides;
        write!(f, "Voxels({x}x{y}x{z} at {:p})", self.values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Is the numbers from 0 to 5 x 6 x 2 - 1.
    static COUNTED: [u8; 60] = {
        let mut values = [0; 60];
        let mut i = 0;
        while i < 60 {
            values[i] = i as u8;
            i += 1;
        }
        values
    };

    #[test]
    fn x_runs_fastest_and_z_slowest() {
        let voxels = Voxels::new([5, 6, 2], &COUNTED);
        assert_eq!(
            [[1, 0, 0], [0, 1, 0], [0, 0, 1], [4, 5, 1]].map(|place| voxels.value(place)),
            [1, 5, 30, 59]
        );
        assert_eq!(voxels.value([0, 0, 2]), 0, "outside");
    }

    #[test]
    fn a_block_knows_the_voxels_at_its_cells_corners_and_the_last_one_ends_with_the_grid() {
        let voxels = Voxels::new([5, 6, 2], &COUNTED);
        // Four cells have five voxels; 5 cells along y make two blocks.
        assert_eq!(voxels.block_sides(), [1, 2, 1]);
        assert_eq!([[0, 0, 0], [0, 1, 0]].map(|block| voxels.extremes(block)), [[0, 54], [20, 59]]);
        static BLOCKS: [u8; 4] = [0, 54, 20, 59];
        let baked = voxels.with_blocks(&BLOCKS);
        assert_eq!([[3, 3, 0], [0, 4, 0]].map(|cell| baked.of_block(cell)), [Some([0, 54]), Some([20, 59])]);
        assert!(baked.fits() && voxels.of_block([0; 3]).is_none());
        assert_eq!(voxels.of_cell([1, 2, 0]), [11, 47]);
    }

    #[test]
    fn sides_and_bytes_must_agree() {
        let fits = |sides| Voxels::new(sides, &COUNTED).fits();
        assert!(fits([5, 6, 2]) && fits([2, 15, 2]));
        assert!(!fits([5, 6, 3]) && !fits([60, 1, 1]) && !fits([5, 12, 1]));
        assert!(!Voxels::new([5, 6, 2], &COUNTED).with_blocks(&COUNTED).fits());
        static LONG: [u8; 4100] = [0; 4100];
        assert!(!Voxels::new([1025, 2, 2], &LONG).fits(), "longer than can be counted");
    }
}
