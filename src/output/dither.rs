/// Names how the rounding to a panel's levels is spread.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dither {
    /// Rounds each pixel to the nearest level.
    None,
    /// Rounds by a threshold that changes from pixel to pixel in a square of eight, so that the
    /// mean of a square is right (Bayer 1973).
    #[default]
    Ordered,
}

/// Is the side of the square of thresholds.
const SIDE: usize = 8;

/// Holds the thresholds of a row of the square, fractions of 2^16: added before rounding down.
pub type Thresholds = [u16; SIDE];

static NEAREST: Thresholds = [1 << 15; SIDE];
static ORDERED: [Thresholds; SIDE] = ordered();

const fn ordered() -> [Thresholds; SIDE] {
    let mut table = [[0; SIDE]; SIDE];
    let mut i = 0;
    while i < SIDE * SIDE {
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
    /// Answers the thresholds of a row of the picture; they come round every eight pixels.
    pub fn thresholds(self, y: u32) -> &'static Thresholds {
        match self {
            Self::None => &NEAREST,
            Self::Ordered => ORDERED.get(y as usize % SIDE).unwrap_or(&NEAREST),
        }
    }

    /// Answers the threshold of a pixel, as a fraction of 2^16: added before rounding down.
    pub fn threshold(self, x: u32, y: u32) -> u32 {
        self.thresholds(y).get(x as usize % SIDE).map_or(1 << 15, |threshold| u32::from(*threshold))
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
