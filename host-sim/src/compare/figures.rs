use crate::panel::Panel;
use serde::{Deserialize, Serialize};

/// Is the ratio reported for equal pictures, whose own is infinite and no JSON number.
pub const BEST_PSNR: f64 = 99.0;

/// Names what is judged.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The view's name.
    pub scene: &'a str,
    /// The core's number.
    pub number: &'a str,
    /// The panel it is shown on.
    pub panel: Panel,
}

/// Says how far a picture on a panel is from the reference on the same panel.
///
/// Differences are those of the 8-bit channels a panel shows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figures {
    /// The view's name.
    pub scene: String,
    /// The core's number.
    pub number: String,
    /// The panel's name.
    pub panel: String,
    /// Peak signal-to-noise ratio in dB away from silhouettes, at most [`BEST_PSNR`].
    pub psnr_db: f64,
    /// Peak signal-to-noise ratio in dB of the whole picture, at most [`BEST_PSNR`].
    pub psnr_all_db: f64,
    /// Largest difference of a channel in the whole picture, as a share of 1.
    pub worst: f64,
    /// Share of all pixels with a channel off by more than 1/255.
    pub over_1: f64,
    /// Share of all pixels with a channel off by more than 8/255.
    pub over_8: f64,
    /// Share of all pixels beside silhouettes.
    pub silhouette: f64,
}

/// Answers the ratio for squared differences of pixels.
fn psnr(squares: impl Iterator<Item = u32>) -> f64 {
    let (sum, count) = squares.fold((0_u64, 0_u64), |(sum, n), square| (sum + u64::from(square), n + 1));
    if sum == 0 {
        return BEST_PSNR;
    }
    let mean = sum as f64 / (3 * count) as f64;
    (10.0 * (255.0 * 255.0 / mean).log10()).min(BEST_PSNR)
}

fn off_by([a, b]: [&[u8; 3]; 2]) -> [u32; 3] {
    std::array::from_fn(|i| u32::from(a[i].abs_diff(b[i])))
}

fn share(count: usize, all: usize) -> f64 {
    if all == 0 { 0.0 } else { count as f64 / all as f64 }
}

impl Figures {
    /// Judges a shown picture by the reference's; all three have a place for each pixel.
    pub fn of(subject: Subject<'_>, shown: &[[u8; 3]], reference: &[[u8; 3]], mask: &[bool]) -> Self {
        let off: Vec<[u32; 3]> = shown.iter().zip(reference).map(|(a, b)| off_by([a, b])).collect();
        let square = |off: &[u32; 3]| off.iter().map(|n| n * n).sum::<u32>();
        let largest: Vec<u32> = off.iter().map(|[r, g, b]| *r.max(g).max(b)).collect();
        let over = |limit: u32| share(largest.iter().filter(|n| **n > limit).count(), largest.len());
        let clear = off.iter().zip(mask).filter(|(_, masked)| !**masked);
        Self {
            scene: subject.scene.to_owned(),
            number: subject.number.to_owned(),
            panel: subject.panel.name().to_owned(),
            psnr_db: psnr(clear.map(|(off, _)| square(off))),
            psnr_all_db: psnr(off.iter().map(square)),
            worst: f64::from(largest.iter().copied().max().unwrap_or(0)) / 255.0,
            over_1: over(1),
            over_8: over(8),
            silhouette: share(mask.iter().filter(|masked| **masked).count(), mask.len()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SUBJECT: Subject<'_> = Subject { scene: "s", number: "n", panel: Panel::Rgb888 };

    #[test]
    fn equal_pictures_have_the_best_ratio_and_no_difference() {
        let picture = [[1, 2, 3], [4, 5, 6]];
        let figures = Figures::of(SUBJECT, &picture, &picture, &[false, true]);
        assert_eq!([figures.psnr_db, figures.psnr_all_db], [BEST_PSNR; 2]);
        assert_eq!([figures.worst, figures.over_1, figures.over_8], [0.0; 3]);
        assert_eq!(figures.silhouette, 0.5);
    }

    #[test]
    fn a_wrong_pixel_beside_a_silhouette_counts_in_all_figures_but_one() {
        let (shown, right) = ([[0; 3], [51, 0, 0]], [[0; 3]; 2]);
        let figures = Figures::of(SUBJECT, &shown, &right, &[false, true]);
        assert_eq!(figures.psnr_db, BEST_PSNR);
        // A mean square of 51 * 51 / 6 is 1/150 of 255 * 255.
        assert!((figures.psnr_all_db - 10.0 * 150_f64.log10()).abs() < 1e-12);
        assert_eq!([figures.worst, figures.over_1, figures.over_8], [0.2, 0.5, 0.5]);
        let clear = Figures::of(SUBJECT, &shown, &right, &[true, false]);
        assert!((clear.psnr_db - 10.0 * 75_f64.log10()).abs() < 1e-12);
    }

    #[test]
    fn the_limits_are_passed_only_beyond_one_and_eight_levels() {
        let shown = [[1, 0, 0], [2, 0, 0], [0, 8, 0], [0, 0, 9]];
        let figures = Figures::of(SUBJECT, &shown, &[[0; 3]; 4], &[false; 4]);
        assert_eq!([figures.over_1, figures.over_8], [0.75, 0.25]);
    }
}
