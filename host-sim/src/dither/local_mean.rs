use std::ops::Range;

/// Names over which neighbours a mean is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Window {
    /// Over a square of 8 by 8 pixels, all alike.
    Box,
    /// Around a pixel, by a Gaussian of a standard deviation of 1.5 pixels: about what the eye does.
    Gaussian,
}

impl Window {
    /// Answers how far left a row of it begins, and the weights of its pixels.
    fn weights(self) -> (isize, Vec<f64>) {
        match self {
            Self::Box => (-4, vec![1.0; 8]),
            // Beyond 6 pixels is less than 1/2000 of the weight.
            Self::Gaussian => {
                (-6, (-6..=6).map(|step| (-0.5 * (f64::from(step) / 1.5).powi(2)).exp()).collect())
            }
        }
    }

    /// Answers the means along a line; what of a window hangs over its ends is left out.
    fn means(self, line: &[f64]) -> Vec<f64> {
        let (first, weights) = self.weights();
        let mean = |place: usize| {
            let taps = (place as isize + first..).zip(&weights);
            let inside = taps.filter_map(|(at, weight)| Some((line.get(usize::try_from(at).ok()?)?, weight)));
            let (sum, whole) =
                inside.fold((0.0, 0.0), |(s, w), (value, weight)| (s + value * weight, w + weight));
            sum / whole
        };
        (0..line.len()).map(mean).collect()
    }
}

/// Answers how far the local means of a picture are from those of what it was to show: the root of the
/// mean square over all pixels and channels, in the unit of both.
///
/// Both are given row by row, `columns` pixels to a row.
pub fn error(shown: &[[f64; 3]], wanted: &[[f64; 3]], columns: usize, window: Window) -> f64 {
    let channels: Range<usize> = 0..3;
    let squares = channels.map(|channel| {
        let off: Vec<f64> = shown.iter().zip(wanted).map(|(a, b)| a[channel] - b[channel]).collect();
        // Along the rows, then along what were the columns.
        let along = |lines: &[f64], length: usize| -> Vec<f64> {
            let lines: Vec<_> = lines.chunks(length.max(1)).map(|line| window.means(line)).collect();
            (0..length).flat_map(|place| lines.iter().map(move |line| line[place])).collect()
        };
        let means = along(&along(&off, columns), off.len() / columns.max(1));
        means.into_iter().map(|mean| mean * mean).sum::<f64>()
    });
    (squares.sum::<f64>() / (3 * shown.len().max(1)) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chessboard_has_the_mean_of_its_grey_and_a_brighter_picture_is_off_by_as_much_everywhere() {
        let grey = [[0.5; 3]; 24 * 16];
        let chessboard: Vec<[f64; 3]> = (0..24 * 16).map(|i| [((i + i / 24) % 2) as f64; 3]).collect();
        for window in [Window::Box, Window::Gaussian] {
            // At the edges a window has an odd pixel more.
            assert!(error(&chessboard, &grey, 24, window) < 0.02, "{window:?}");
            assert!((error(&[[0.75; 3]; 24 * 16], &grey, 24, window) - 0.25).abs() < 1e-12);
        }
    }

    #[test]
    fn a_single_pixel_spreads_over_its_window() {
        let mut dot = [[0.0; 3]; 32 * 20];
        dot[10 * 32 + 15] = [64.0; 3];
        let off = error(&dot, &[[0.0; 3]; 32 * 20], 32, Window::Box);
        // It is a mean of 1 in 64 windows.
        assert!((off - (64.0_f64 / 640.0).sqrt()).abs() < 1e-12, "{off}");
    }
}
