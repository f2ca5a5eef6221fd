//! What a panel shows after each pass of a picture that becomes finer.

use std::convert::Infallible;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use scanray::{Fixed, Progress, Renderer, Workspace, gallery::View};

/// Is a square panel as the bus sees it.
struct Panel<const SIDE: usize>(Vec<[u8; 2]>);

impl<const SIDE: usize> OriginDimensions for Panel<SIDE> {
    fn size(&self) -> Size {
        Size::new_equal(SIDE as u32)
    }
}

impl<const SIDE: usize> DrawTarget for Panel<SIDE> {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(Point { x, y }, color) in pixels {
            self.0[y as usize * SIDE + x as usize] = color.into_storage().to_be_bytes();
        }
        Ok(())
    }
}

/// Answers the side of the blocks of each pass, the first of 16, and the bytes that the panel then shows.
pub fn of<const SIDE: usize>(view: &View<Fixed>) -> Vec<(u8, Vec<u8>)> {
    let mut space = Workspace::<Fixed, Rgb565, SIDE, 5>::new();
    let mut panel = Panel::<SIDE>(vec![[0; 2]; SIDE * SIDE]);
    let mut renderer = Renderer::new(&view.scene, &view.camera, panel.size(), view.settings, &mut space)
        .expect("the host refuses what the board draws");
    let (mut progress, mut passes) = (Progress::new(16), Vec::new());
    while !progress.is_complete() {
        let side = progress.side();
        let Ok(_) = renderer.refine(&mut progress, &mut panel);
        if progress.side() != side {
            passes.push((side, panel.0.concat()));
        }
    }
    passes
}
