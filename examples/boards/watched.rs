//! A panel that tells a stopwatch who is at work: the core, which renders, or the panel's driver, which sends.

use embedded_graphics::{pixelcolor::PixelColor, prelude::*, primitives::Rectangle};

/// Hears when the work changes hands.
pub trait Stopwatch {
    /// Hears that the core begins, or goes on, to render.
    fn rendering(&mut self);

    /// Hears that the panel's driver takes over.
    fn sending(&mut self);
}

/// Draws on `panel` and keeps `watch` informed.
pub struct Watched<'a, D, W> {
    panel: &'a mut D,
    watch: &'a mut W,
}

impl<'a, D: DrawTarget, W: Stopwatch> Watched<'a, D, W> {
    /// Begins to watch: rendering begins now.
    pub fn new(panel: &'a mut D, watch: &'a mut W) -> Self {
        watch.rendering();
        Self { panel, watch }
    }

    fn send<T>(&mut self, work: impl FnOnce(&mut D) -> T) -> T {
        self.watch.sending();
        let done = work(self.panel);
        self.watch.rendering();
        done
    }
}

impl<D: DrawTarget, W> Dimensions for Watched<'_, D, W> {
    fn bounding_box(&self) -> Rectangle {
        self.panel.bounding_box()
    }
}

impl<C: PixelColor, D: DrawTarget<Color = C>, W: Stopwatch> DrawTarget for Watched<'_, D, W> {
    type Color = C;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        self.send(|panel| panel.draw_iter(pixels))
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), D::Error> {
        self.send(|panel| panel.fill_contiguous(area, colors))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), D::Error> {
        self.send(|panel| panel.fill_solid(area, color))
    }
}
