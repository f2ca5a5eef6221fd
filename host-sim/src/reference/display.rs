use super::description::{Output, Rounding};
use super::vector::Vector;

/// Answers Bayer's matrix of side `2^k` by its definition: four copies of the half as large one,
/// four times as deep, with 0, 2, 3 and 1 added.
fn bayer(k: u32) -> Vec<Vec<u32>> {
    if k == 0 {
        return vec![vec![0]];
    }
    let half = bayer(k - 1);
    let joined = |left: u32, right: u32| {
        let both = move |row: &Vec<u32>| {
            row.iter().map(|n| 4 * n + left).chain(row.iter().map(|n| 4 * n + right)).collect()
        };
        half.iter().map(both).collect::<Vec<Vec<u32>>>()
    };
    [joined(0, 2), joined(3, 1)].concat()
}

/// Answers the level of linear light, 0 to 1, by the curve (IEC 61966-2-1).
fn srgb(light: f64) -> f64 {
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

/// Turns light into what a panel shows of it, in 8 bits a channel.
pub(super) struct Display {
    output: Output,
    /// Thresholds by row and column, repeated over the picture.
    thresholds: Vec<Vec<f64>>,
}

impl Display {
    /// Makes the panel's thresholds: those of a square, or a half everywhere.
    pub fn of(output: Output) -> Self {
        let by_rank = |order: Vec<Vec<u32>>| {
            let steps = (order.len() * order.len()) as f64;
            let threshold = |n: u32| (2.0 * f64::from(n) + 1.0) / (2.0 * steps);
            order.into_iter().map(|row| row.into_iter().map(threshold).collect()).collect()
        };
        let thresholds = match output.rounding {
            Rounding::Nearest | Rounding::Diffused => by_rank(bayer(0)),
            Rounding::Ordered => by_rank(bayer(3)),
            Rounding::Mask(mask) => mask.map(|row| row.map(|n| f64::from(n) / 65_536.0).to_vec()).to_vec(),
        };
        Self { output, thresholds }
    }

    /// Answers how bright the channels are to be, in the panel's levels.
    fn wanted(&self, light: Vector) -> [f64; 3] {
        let [r, g, b] = light.0.map(|l| l.clamp(0.0, 1.0));
        let luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
        let channels = if self.output.colored { [r, g, b] } else { [luminance; 3] };
        let bright = channels.map(|light| if self.output.srgb { srgb(light) } else { light });
        std::array::from_fn(|i| bright[i] * self.output.tops[i])
    }

    /// Answers what is shown of the lights of row `y`.
    pub fn row(&self, light: &[Vector], y: usize) -> Vec<[u8; 3]> {
        let side = self.thresholds.len();
        let diffused = self.output.rounding == Rounding::Diffused;
        // The first error of a row: multiples of the golden ratio, as a half more or less.
        let first = (y as f64 * 40_503.0 / 65_536.0).fract() - 0.5;
        let mut errors = [if diffused { first } else { 0.0 }; 3];
        let pixel = |(x, light): (usize, &Vector)| {
            let wanted = self.wanted(*light);
            let tops = self.output.tops;
            std::array::from_fn(|i| {
                let level = wanted[i] + errors[i];
                let rounded = (level + self.thresholds[y % side][x % side]).floor().clamp(0.0, tops[i]);
                errors[i] = if diffused { level - rounded } else { 0.0 };
                (rounded / tops[i] * 255.0).round() as u8
            })
        };
        light.iter().enumerate().map(pixel).collect()
    }
}

/// Answers how bright a panel's channels are to be for a light, in the panel's steps.
pub fn wanted(output: Output, light: Vector) -> [f64; 3] {
    Display::of(output).wanted(light)
}

/// Answers what a panel shows of the last of these lights, in 8 bits a channel: they are those of row `y` from its
/// left on.
pub fn shown(output: Output, lights: &[Vector], y: u32) -> [u8; 3] {
    Display::of(output).row(lights, y as usize).last().copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_matrix_of_side_four_is_bayers() {
        let expected = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];
        assert_eq!(bayer(2), expected.map(Vec::from));
    }

    #[test]
    fn the_curve_has_its_published_values() {
        assert!((srgb(0.5) - 0.735_356_983_052_449_4).abs() < 1e-12);
        assert!((srgb(0.002) - 0.025_84).abs() < 1e-15);
    }

    #[test]
    fn half_light_lights_half_the_pixels_of_a_black_and_white_panel() {
        for rounding in [Rounding::Ordered, Rounding::Diffused] {
            let display = Display::of(Output { tops: [1.0; 3], colored: false, srgb: false, rounding });
            let rows = (0..8).flat_map(|y| display.row(&[Vector([0.5; 3]); 8], y));
            assert_eq!(rows.filter(|shown| *shown == [255; 3]).count(), 32, "{rounding:?}");
        }
    }
}
