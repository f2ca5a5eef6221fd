use crate::color::Rgb;
use crate::math::Scalar;

/// Holds the linear light of each level of 8 bits, in fractions of 2^24: 1 KB of flash.
static LIGHT: [u32; 256] = light();

/// Answers the fifth root by Newton's method, from above.
const fn fifth_root(x: f64) -> f64 {
    let mut y = 1.0;
    let mut i = 0;
    while i < 40 {
        let y2 = y * y;
        y -= (y - x / (y2 * y2)) / 5.0;
        i += 1;
    }
    y
}

const fn light() -> [u32; 256] {
    let mut table = [0; 256];
    let mut i = 0;
    while i < 256 {
        let level = i as f64 / 255.0;
        let light = if level <= 0.04045 {
            level / 12.92
        } else {
            // x^2.4 is x^2 times the fifth root of x^2.
            let x = (level + 0.055) / 1.055;
            x * x * fifth_root(x * x)
        };
        table[i] = (light * 16_777_216.0 + 0.5) as u32;
        i += 1;
    }
    table
}

/// Answers the linear light of sRGB levels (IEC 61966-2-1; row X2 backwards), rounded to 2^-24.
pub(crate) fn decode<S: Scalar>(levels: [u8; 3]) -> Rgb<S> {
    let [r, g, b] = levels.map(|level| S::from_light_bits(LIGHT[usize::from(level)]));
    Rgb::new(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_the_curve_to_its_last_digit() {
        for (level, light) in (0..=255_u8).zip(LIGHT) {
            let exact = match f64::from(level) / 255.0 {
                low if low <= 0.04045 => low / 12.92,
                x => ((x + 0.055) / 1.055).powf(2.4),
            };
            assert!((f64::from(light) - exact * 16_777_216.0).abs() <= 0.5, "level {level}");
        }
    }

    #[test]
    fn black_is_no_light_and_white_is_all_of_it() {
        assert_eq!(decode::<f32>([0, 255, 0]), Rgb::new(0.0, 1.0, 0.0));
        assert_eq!(decode::<crate::Fixed>([255; 3]), Rgb::WHITE);
    }
}
