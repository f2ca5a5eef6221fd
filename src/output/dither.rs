/// Names how the rounding to a panel's levels is spread.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dither {
    /// Rounds each pixel to the nearest level.
    None,
    /// Rounds by a threshold that changes from pixel to pixel in a square of eight, so that the
    /// mean of a square is right (Bayer 1973).
    #[default]
    Ordered,
    /// Rounds by the thresholds of a square of sixteen, such as [`BLUE_NOISE`](super::BLUE_NOISE); the mean
    /// of a square is as right as its thresholds are even. A mask is in flash only where it is named.
    Mask(&'static Mask),
    /// Hands what rounding leaves of a pixel to the next one to its right, so that the mean of any part of
    /// a row is right to a level divided by its length (error diffusion in one dimension).
    ///
    /// Floyd and Steinberg (1976) hand most of it to the row below. Here rows do not depend on each other,
    /// which lets them be drawn in any order, on any core: each begins with a remainder of its own instead,
    /// those of neighbours as far apart as the golden ratio can keep them, and all run to the right. A part
    /// of a row is therefore traced from its first column on, so that it comes out as the whole does. An
    /// adaptive row is filled in first and rounded then, from left to right like an exact one; a pixel that
    /// is drawn without those to its left, as in a coarse pass, is rounded as by [`Self::Ordered`].
    Diffused,
}

/// Is the side of a mask, the number of thresholds after which a row's come round.
pub const SIDE: usize = 16;

/// Holds the thresholds of a row, fractions of 2^16: added before rounding down.
pub type Thresholds = [u16; SIDE];

/// Holds the thresholds of a square of pixels, row by row from the top; it is repeated over the picture.
pub type Mask = [Thresholds; SIDE];

/// Is after how many rows the thresholds of the ordered square come round.
const ORDERED_SIDE: usize = 8;

static NEAREST: Thresholds = [1 << 15; SIDE];
static ORDERED: [Thresholds; ORDERED_SIDE] = ordered();

const fn ordered() -> [Thresholds; ORDERED_SIDE] {
    let mut table = [[0; SIDE]; ORDERED_SIDE];
    let mut i = 0;
    while i < SIDE * ORDERED_SIDE {
        let (x, y) = (i % SIDE, i / SIDE);
        // The bits of x ^ y and y, taken in turn, the lowest first and made the highest: the order
        // in which the pixels of the square light up.
        let (mut order, mut bit) = (0, 0);
        while bit < 3 {
            order = order << 2 | (((x ^ y) >> bit) & 1) << 1 | (y >> bit) & 1;
            bit += 1;
        }
        // The middle of the step, so that neither black nor white is ever broken up.
        table[y][x] = (2 * order as u16 + 1) << 9;
        i += 1;
    }
    table
}

impl Dither {
    /// Answers the thresholds of a row of the picture; they come round every sixteen pixels.
    pub fn thresholds(self, y: u32) -> &'static Thresholds {
        let y = y as usize;
        match self {
            Self::None => &NEAREST,
            Self::Ordered | Self::Diffused => ORDERED.get(y % ORDERED_SIDE).unwrap_or(&NEAREST),
            Self::Mask(mask) => mask.get(y % SIDE).unwrap_or(&NEAREST),
        }
    }

    /// Answers the threshold of a pixel, as a fraction of 2^16: added before rounding down.
    pub fn threshold(self, x: u32, y: u32) -> u32 {
        self.thresholds(y).get(x as usize % SIDE).map_or(1 << 15, |threshold| u32::from(*threshold))
    }

    /// Tells whether each pixel is rounded by itself, whatever the order in which they are drawn.
    pub(crate) fn is_pointwise(self) -> bool {
        !matches!(self, Self::Diffused)
    }

    /// Answers from which column on a row's pixels decide what those from `column` on look like.
    pub(crate) fn first_column(self, column: u32) -> u32 {
        if self.is_pointwise() { column } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_threshold_comes_once_and_neighbours_lie_far_apart() {
        let mut seen = [false; 64];
        for (x, y) in (0..8).flat_map(|y| (0..8).map(move |x| (x, y))) {
            let threshold = Dither::Ordered.threshold(x, y);
            seen[(threshold >> 10) as usize] = true;
            let right = Dither::Ordered.threshold(x + 1, y);
            assert!(threshold.abs_diff(right) >= 1 << 13, "at {x}, {y}");
        }
        assert!(seen.iter().all(|s| *s));
    }
}
