use super::{Dither, Encode, Quantizer, Thresholds, Transfer};

/// Is how far a row's first remainder is from that of the row above, as a fraction of 2^16: the golden
/// ratio, whose multiples leave no row near those of its neighbours (Weyl 1916).
const GOLDEN: u32 = 40_503;

/// Rounds the pixels of a row, one after the other from the row's left.
///
/// ```
/// use embedded_graphics_core::pixelcolor::BinaryColor;
/// use scanray::output::Rounding;
/// use scanray::{Dither, Transfer};
///
/// let mut rounding = Rounding::of_row(Dither::Diffused, 0);
/// let quarter_light = [1 << 22; 3];
/// let row: [BinaryColor; 8] =
///     std::array::from_fn(|x| rounding.encode(x as u32, quarter_light, Transfer::Linear));
/// assert_eq!(row.iter().filter(|pixel| pixel.is_on()).count(), 2);
/// ```
#[derive(Clone, Debug)]
pub struct Rounding {
    thresholds: &'static Thresholds,
    /// What rounding has left of each channel, a fraction of 2^16, if it is handed on.
    remainders: Option<[u32; 3]>,
}

impl Rounding {
    /// Makes the rounding of row `y`.
    pub fn of_row(dither: Dither, y: u32) -> Self {
        let first = y.wrapping_mul(GOLDEN) & 0xffff;
        let remainders = matches!(dither, Dither::Diffused).then_some([first; 3]);
        Self { thresholds: dither.thresholds(y), remainders }
    }

    /// Makes the colour of the 24-bit lights of the pixel in column `x`.
    pub fn encode<P: Encode>(&mut self, x: u32, light: [u32; 3], transfer: Transfer) -> P {
        match &mut self.remainders {
            None => P::encode(light, Quantizer::of_threshold(transfer, self.threshold(x))),
            Some(remainders) => diffuse(P::levels(light, transfer), remainders),
        }
    }

    /// Rounds the levels of the pixel in column `x` to a colour.
    pub fn round<P: Encode>(&mut self, x: u32, levels: [u32; 3]) -> P {
        match &mut self.remainders {
            None => P::from_levels(levels, u32::from(self.threshold(x))),
            Some(remainders) => diffuse(levels, remainders),
        }
    }

    fn threshold(&self, x: u32) -> u16 {
        self.thresholds[x as usize % self.thresholds.len()]
    }
}

/// Rounds by what the pixels before have left, and leaves what this one has.
#[inline(never)]
fn diffuse<P: Encode>(levels: [u32; 3], remainders: &mut [u32; 3]) -> P {
    let thresholds = *remainders;
    for ((remainder, level), top) in remainders.iter_mut().zip(levels).zip(P::TOPS) {
        // The threshold is added before rounding down: what is cut off is the error and the next threshold.
        *remainder = level.wrapping_mul(u32::from(top)).wrapping_add(*remainder) & 0xffff;
    }
    P::by_thresholds(levels, thresholds)
}
