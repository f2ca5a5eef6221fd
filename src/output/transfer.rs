/// Names how linear light becomes panel levels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Transfer {
    /// The sRGB curve (IEC 61966-2-1), as panels and PNG files expect it (row X2).
    #[default]
    Srgb,
    /// Levels proportional to light, as the classic small ray tracers write them.
    Linear,
}

/// Is how many pieces each doubling of the light is cut into.
///
/// 32 keep the chord within 5e-5 of the curve: 1/80 of a step of an 8-bit channel.
const PIECES: usize = 32;
/// Is the doubling in which the curve's straight foot ends: 0.0031308 * 2^24 lies above 2^15.
const FIRST_DOUBLING: u32 = 15;
const DOUBLINGS: usize = 9;

/// Holds the curve at the ends of all pieces, as fractions of 2^15.
static CURVE: [u16; DOUBLINGS * PIECES + 1] = curve();

/// Answers the twelfth root by Newton's method, from above.
const fn twelfth_root(x: f64) -> f64 {
    let mut y = 1.0;
    let mut i = 0;
    while i < 40 {
        let y2 = y * y;
        let y4 = y2 * y2;
        y -= (y - x / (y4 * y4 * y2 * y)) / 12.0;
        i += 1;
    }
    y
}

const fn curve() -> [u16; DOUBLINGS * PIECES + 1] {
    let mut table = [0; DOUBLINGS * PIECES + 1];
    let mut i = 0;
    while i <= DOUBLINGS * PIECES {
        let doubling = (1_u32 << (FIRST_DOUBLING as usize + i / PIECES)) as f64 / 16_777_216.0;
        let light = doubling * (1.0 + (i % PIECES) as f64 / PIECES as f64);
        // x^(1 / 2.4) is the twelfth root of x^5.
        let root = twelfth_root(light * light * light * light * light);
        table[i] = ((1.055 * root - 0.055) * 32_768.0 + 0.5) as u16;
        i += 1;
    }
    table
}

/// Answers the sRGB level of a 24-bit light as a fraction of 2^16.
fn srgb(light: u32) -> u32 {
    // 0.0031308 * 2^24; below it the curve is the line 12.92 x = 13230 x / 2^10.
    if light <= 52_526 {
        return (light * 13_230) >> 18;
    }
    let doubling = 31 - light.leading_zeros();
    let shift = doubling - 5;
    let piece = (doubling - FIRST_DOUBLING) as usize * PIECES + ((light >> shift) & 31) as usize;
    match CURVE.get(piece..) {
        Some([low, high, ..]) => {
            let (low, high) = (u32::from(*low), u32::from(*high));
            let inside = light & ((1 << shift) - 1);
            2 * low + (((high - low) * inside) >> (shift - 1))
        }
        _ => 1 << 16,
    }
}

impl Transfer {
    /// Answers the level of a 24-bit light as a fraction of 2^16, within 5e-5 of the exact curve.
    pub fn level(self, light: u32) -> u32 {
        match self {
            Self::Srgb => srgb(light.min(1 << 24)),
            Self::Linear => light.min(1 << 24) >> 8,
        }
    }
}
