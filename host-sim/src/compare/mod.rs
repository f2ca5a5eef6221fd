//! Comparison of the core's pictures with the reference's: figures, and pictures of the difference.

mod difference;
mod figures;

pub use difference::difference;
pub use figures::{BEST_PSNR, Figures, Subject};

use crate::panel::Panel;
use crate::picture::Film;
use crate::reference::{self, Description, Output, Picture, Unknown};
use scanray::gallery::View;
use scanray::math::Scalar;
use scanray::{Dither, Settings, Transfer};

/// Holds a reference picture, ready to judge the core's pictures of the same view.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The picture as it ought to be.
    pub reference: Picture,
    /// Marks the pixels beside silhouettes, where either side may be shown.
    pub mask: Vec<bool>,
    transfer: Transfer,
    dither: Dither,
}

/// Is the largest difference of linear light, and the pixel that has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightDifference {
    /// Largest absolute difference of a channel; infinite where one is not a number.
    pub value: f64,
    /// Column and row.
    pub pixel: [u32; 2],
}

impl Comparison {
    /// Traces a view with the reference; `row_done` is told each finished row.
    ///
    /// # Errors
    /// [`Unknown`] names what the reference has no formula for.
    pub fn trace(
        view: &View<f64>,
        settings: Settings<f64>,
        size: [u32; 2],
        row_done: impl FnMut(u32),
    ) -> Result<Self, Unknown> {
        Self::trace_samples(view, settings, size, 1, row_done)
    }

    /// Traces a view with the reference, `side` x `side` rays a pixel.
    ///
    /// # Errors
    /// As there.
    pub fn trace_samples(
        view: &View<f64>,
        settings: Settings<f64>,
        size: [u32; 2],
        side: u32,
        mut row_done: impl FnMut(u32),
    ) -> Result<Self, Unknown> {
        let description = Description::copy(&view.scene, &view.camera, &settings)?;
        let last = |y: &u32| (y + 1).is_multiple_of(side);
        let line_done = |y: u32| Some(y).filter(last).map_or((), |y| row_done(y / side));
        let reference = reference::trace(&description, size.map(|n| n * side), line_done).averaged(side);
        let mask = reference.silhouettes();
        Ok(Self { reference, mask, transfer: settings.transfer, dither: settings.dither })
    }

    /// Answers what a panel shows of the reference, in 8 bits a channel.
    pub fn on_panel(&self, panel: Panel) -> Vec<[u8; 3]> {
        self.reference.on_panel(Output::copy(panel, self.transfer, self.dither))
    }

    /// Judges what a panel shows of the core's picture.
    ///
    /// The film has the size of the reference.
    pub fn figures<S: Scalar + Sync>(&self, subject: Subject<'_>, film: &Film<S>) -> Figures {
        let shown = film.on_panel(subject.panel, self.transfer, self.dither);
        Figures::of(subject, &shown, &self.on_panel(subject.panel), &self.mask)
    }

    /// Answers the largest difference of linear light from an exact film, silhouettes left out.
    pub fn light_difference(&self, film: &Film<f64>) -> LightDifference {
        let mut worst = LightDifference { value: 0.0, pixel: [0, 0] };
        let pairs = film.light.iter().zip(&self.reference.light).zip(&self.mask).enumerate();
        for (i, ((core, reference), _)) in pairs.filter(|(_, (_, masked))| !**masked) {
            let channels = [core.r, core.g, core.b].into_iter().zip(reference.0);
            for off in channels.map(|(a, b)| (a - b).abs()) {
                let value = if off.is_nan() { f64::INFINITY } else { off };
                if value > worst.value {
                    let columns = self.reference.size[0];
                    worst = LightDifference { value, pixel: [i as u32 % columns, i as u32 / columns] };
                }
            }
        }
        worst
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::Vector;
    use scanray::Rgb;
    use scanray::trace::RayCounts;

    fn difference_of(film: [f64; 4], mask: [bool; 4]) -> LightDifference {
        let (size, trails) = ([2, 2], vec![]);
        let reference = Picture { size, light: vec![Vector([0.5; 3]); 4], trails };
        let (transfer, dither) = (Transfer::Srgb, Dither::None);
        let comparison = Comparison { reference, mask: mask.to_vec(), transfer, dither };
        let light = film.map(|blue| Rgb::new(0.5, 0.5, blue)).to_vec();
        comparison.light_difference(&Film { size, light, rays: RayCounts::default() })
    }

    #[test]
    fn the_largest_difference_of_light_is_found_with_its_pixel_but_not_beside_silhouettes() {
        let film = [0.5, 0.75, 0.0, 9.0];
        let clear = difference_of(film, [false, false, false, true]);
        assert_eq!(clear, LightDifference { value: 0.5, pixel: [0, 1] });
        let masked = difference_of(film, [false, false, true, true]);
        assert_eq!(masked, LightDifference { value: 0.25, pixel: [1, 0] });
    }

    #[test]
    fn light_that_is_not_a_number_is_infinitely_off() {
        assert_eq!(difference_of([0.5, f64::NAN, 0.5, 0.5], [false; 4]).value, f64::INFINITY);
    }
}
