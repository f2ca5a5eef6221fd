//! Pictures by the core's z-buffer, the other approach.

use crate::panel::{Panel, Unrounded};
use embedded_graphics_core::geometry::Size;
use scanray::gallery::View;
use scanray::trace::{Observer, RayKind};
use scanray::{Encode, RasterRenderer, RasterWorkspace, RenderError, Scalar};
use std::ops::Range;

/// Is the longest row the host's workspaces have room for.
pub const MAX_WIDTH: usize = 4096;

/// Is what a panel shows of a picture that was rasterised for it, with what it took.
#[derive(Clone, Debug)]
pub struct Rasterized {
    /// Red, green and blue of every pixel in 8 bits, row by row from the top.
    pub pixels: Vec<[u8; 3]>,
    /// Depths that were tested.
    pub fragments: u64,
}

/// Counts the depths that are tested.
struct Fragments(u64);

impl Observer for Fragments {
    fn ray(&mut self, _: RayKind) {}

    fn span(&mut self, _: u16, columns: &Range<u32>) {
        self.0 += columns.len() as u64;
    }
}

/// Draws a picture for a panel row by row, as a device does.
///
/// # Errors
/// What keeps the core from drawing the view.
pub fn draw<S: Scalar>(
    view: &View<S>,
    size: [u32; 2],
    panel: Panel,
    row_done: impl FnMut(u32),
) -> Result<Rasterized, RenderError> {
    if panel.is_gray() {
        draw_in::<S, true>(view, size, panel, row_done)
    } else {
        draw_in::<S, false>(view, size, panel, row_done)
    }
}

fn draw_in<S: Scalar, const GRAY: bool>(
    view: &View<S>,
    [columns, rows]: [u32; 2],
    panel: Panel,
    mut row_done: impl FnMut(u32),
) -> Result<Rasterized, RenderError> {
    let mut workspace = RasterWorkspace::<S, MAX_WIDTH>::new();
    let canvas = Size::new(columns, rows);
    let mut renderer = RasterRenderer::new(&view.scene, &view.camera, canvas, view.settings, &mut workspace)?;
    let mut row = vec![Unrounded::<GRAY>::DARKEST; columns as usize];
    let mut fragments = Fragments(0);
    let mut pixels = Vec::new();
    for y in 0..rows {
        // The row exists, and there is a place for each of its pixels.
        let _ = renderer.watch_row(y, &mut row, &mut fragments);
        pixels.extend(panel.round_row(row.iter().map(|pixel| pixel.levels), view.settings.dither, y));
        row_done(y);
    }
    Ok(Rasterized { pixels, fragments: fragments.0 })
}
