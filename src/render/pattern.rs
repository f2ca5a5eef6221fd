use super::RenderError;

/// Is the most squares along a side of a pixel.
pub const MOST: u8 = 8;

/// Is how many places a scattered sample has along a side of its square.
///
/// Each line of places is one more plane in which candidates are looked for, once a row; four already leave
/// no stripes.
const PLACES: u8 = 4;

/// Is where the rays of a pixel go through it: each through its own of the equal squares of the pixel.
///
/// Places are those of a grid, so that the rays of a row lie in a few planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// Squares along a side.
    side: u8,
    /// Places along a side of a square.
    places: u8,
}

impl Pattern {
    /// Is one ray through the middle.
    pub const MIDDLE: Self = Self::middles(1);

    /// Makes the pattern of rays through the middles of the squares.
    pub const fn middles(side: u8) -> Self {
        Self { side, places: 1 }
    }

    /// Makes the pattern of rays anywhere in the squares.
    pub const fn scattered(side: u8) -> Self {
        Self { side, places: PLACES }
    }

    /// Answers an error where there are no squares, or too many.
    pub fn check(self) -> Result<(), RenderError> {
        match self.side {
            1..=MOST => Ok(()),
            side => Err(RenderError::Samples { side, most: MOST }),
        }
    }

    /// Answers how many rays a pixel takes.
    pub fn count(self) -> u32 {
        u32::from(self.side) * u32::from(self.side)
    }

    /// Answers how many lines of places a pixel has, and as many columns: 32 at most.
    pub fn lines(self) -> u8 {
        self.side.saturating_mul(self.places)
    }

    /// Answers the column and the line of places that sample `number` of a pixel takes.
    pub fn place(self, pixel: [u32; 2], number: u32) -> [u8; 2] {
        let side = u32::from(self.side.max(1));
        let square = [number % side, number / side].map(|place| place as u8);
        if self.places == 1 {
            return square;
        }
        let [right, down] = hash(pixel[0], pixel[1], number);
        let place = |square: u8, random: u16| {
            let inside = random % u16::from(self.places.max(1));
            square.wrapping_mul(self.places).wrapping_add(inside as u8)
        };
        [place(square[0], right), place(square[1], down)]
    }
}

/// Hashes three numbers to two (M. Jarzynski, M. Olano 2020, "Hash Functions for GPU Rendering", pcg3d).
///
/// The upper halves are answered, which are the better ones; 32-bit products alone, so that an M0+ is quick.
fn hash(x: u32, y: u32, z: u32) -> [u16; 2] {
    let mut v = [x, y, z].map(|n| n.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    stir(&mut v);
    v = v.map(|n| n ^ n >> 16);
    stir(&mut v);
    [(v[0] >> 16) as u16, (v[1] >> 16) as u16]
}

fn stir(v: &mut [u32; 3]) {
    v[0] = v[0].wrapping_add(v[1].wrapping_mul(v[2]));
    v[1] = v[1].wrapping_add(v[2].wrapping_mul(v[0]));
    v[2] = v[2].wrapping_add(v[0].wrapping_mul(v[1]));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_hashed_as_published() {
        // pcg3d's x and y of 32 bits: 9bafd7c6 a8e88a6b, fa9f79a6 48f2f44c, 8580f039 5a4b9074.
        let of = [hash(0, 0, 0), hash(1, 2, 3), hash(319, 239, 8)];
        assert_eq!(of, [[0x9baf, 0xa8e8], [0xfa9f, 0x48f2], [0x8580, 0x5a4b]]);
    }

    #[test]
    fn every_sample_stays_in_its_own_square() {
        for side in 1..=MOST {
            for number in 0..u32::from(side) * u32::from(side) {
                let square = [number % u32::from(side), number / u32::from(side)];
                assert_eq!(Pattern::middles(side).place([3, 5], number).map(u32::from), square);
                for pixel in 0..if cfg!(miri) { 4 } else { 200 } {
                    let place = Pattern::scattered(side).place([pixel, 7 * pixel], number).map(u32::from);
                    assert_eq!(place.map(|n| n / u32::from(PLACES)), square);
                }
            }
        }
    }

    #[test]
    fn scattered_samples_take_every_place_about_equally_often() {
        let mut taken = [[0_u32; PLACES as usize]; PLACES as usize];
        for (x, y) in (0..64).flat_map(|y| (0..64).map(move |x| (x, y))) {
            let [column, line] = Pattern::scattered(1).place([x, y], 0);
            taken[line as usize][column as usize] += 1;
        }
        // 256 each, with a deviation of 15.
        assert!(taken.as_flattened().iter().all(|count| (180..=332).contains(count)), "{taken:?}");
    }

    #[test]
    fn neighbours_scatter_unlike_each_other() {
        let pattern = Pattern::scattered(2);
        let pixel = |x, y| [0, 1, 2, 3].map(|number| pattern.place([x, y], number));
        let alike =
            (0..400).filter(|x| pixel(*x, 9) == pixel(x + 1, 9) || pixel(*x, 9) == pixel(*x, 10)).count();
        assert!(alike <= 2, "{alike} of 400");
    }
}
