/// Is the side of the mask.
pub const SIDE: usize = 16;
const COUNT: usize = SIDE * SIDE;

/// Is how wide a pixel's influence is, in pixels (Ulichney 1993: 1.5).
const SIGMA: f64 = 1.5;

/// Knows which pixels are on, and how crowded each place of the endless tiling is.
#[derive(Clone)]
struct Pattern {
    on: [bool; COUNT],
    /// Sums of the influences of all pixels that are on, in whole numbers so that equals are equal.
    crowd: [u64; COUNT],
    /// The influence of a pixel on another, by how far right and down that is.
    influence: [u64; COUNT],
}

impl Pattern {
    fn empty() -> Self {
        let away = |steps: usize| steps.min(SIDE - steps) as f64;
        let influence = |place: usize| {
            let (x, y) = (away(place % SIDE), away(place / SIDE));
            ((-(x * x + y * y) / (2.0 * SIGMA * SIGMA)).exp() * f64::from(1 << 24)).round() as u64
        };
        Self { on: [false; COUNT], crowd: [0; COUNT], influence: std::array::from_fn(influence) }
    }

    fn flip(&mut self, place: usize) {
        self.on[place] = !self.on[place];
        for other in 0..COUNT {
            let (right, down) = (SIDE + other % SIDE - place % SIDE, SIDE + other / SIDE - place / SIDE);
            let influence = self.influence[down % SIDE * SIDE + right % SIDE];
            self.crowd[other] =
                if self.on[place] { self.crowd[other] + influence } else { self.crowd[other] - influence };
        }
    }

    /// Answers the pixel that is on in the greatest crowd.
    fn tightest_cluster(&self) -> usize {
        let on = (0..COUNT).filter(|place| self.on[*place]);
        on.max_by_key(|place| self.crowd[*place]).unwrap_or(0)
    }

    /// Answers the pixel that is off where it is loneliest.
    fn largest_void(&self) -> usize {
        let off = (0..COUNT).filter(|place| !self.on[*place]);
        off.min_by_key(|place| self.crowd[*place]).unwrap_or(0)
    }

    /// Makes a pattern of a tenth of the pixels, as evenly spread as moving single ones makes it.
    fn prototype() -> Self {
        let mut pattern = Self::empty();
        let mut random: u32 = 1;
        while pattern.on.iter().filter(|on| **on).count() < COUNT / 10 {
            // Any seed does: the moves below forget it but for where the pattern lies.
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let place = (random >> 16) as usize % COUNT;
            if !pattern.on[place] {
                pattern.flip(place);
            }
        }
        loop {
            let cluster = pattern.tightest_cluster();
            pattern.flip(cluster);
            let void = pattern.largest_void();
            pattern.flip(void);
            if void == cluster {
                return pattern;
            }
        }
    }
}

/// Answers the order in which the pixels of a square light up, 0 to 255 (R. Ulichney, "The void-and-cluster
/// method for dither array generation", 1993).
///
/// The prototype's pixels are ranked from the tightest cluster down, the others from the largest void up.
/// That the last half fills voids too, where Ulichney has it dissolve clusters of dark pixels, is the same:
/// influences are sums, so that dark is most crowded where light is least.
pub fn void_and_cluster() -> [[u8; SIDE]; SIDE] {
    let prototype = Pattern::prototype();
    let mut ranks = [[0; SIDE]; SIDE];
    let mut rank = |place: usize, rank: usize| ranks[place / SIDE][place % SIDE] = rank as u8;
    let first = prototype.on.iter().filter(|on| **on).count();
    let mut falling = prototype.clone();
    for order in (0..first).rev() {
        let cluster = falling.tightest_cluster();
        falling.flip(cluster);
        rank(cluster, order);
    }
    let mut rising = prototype;
    for order in first..COUNT {
        let void = rising.largest_void();
        rising.flip(void);
        rank(void, order);
    }
    ranks
}
