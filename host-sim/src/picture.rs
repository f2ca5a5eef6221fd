//! Pictures as the core makes them: linear light of every pixel, and the same on a panel.

use crate::panel::{Panel, Unrounded};
use scanray::gallery::View;
use scanray::math::Scalar;
use scanray::trace::RayCounts;
use scanray::{Dither, Encode, Quality, RenderError, Renderer, Rgb, Settings, Transfer, Workspace};

use embedded_graphics_core::geometry::Size;

/// Is the most bounces the host's workspaces have room for.
pub const MAX_DEPTH: usize = 32;

/// Is the linear light of every pixel, row by row from the top, with what it took.
#[derive(Clone, Debug)]
pub struct Film<S> {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Light of every pixel after exposure.
    pub light: Vec<Rgb<S>>,
    /// Rays traced for it.
    pub rays: RayCounts,
}

/// Traces a picture with the core in its number.
///
/// `row_done` is told each finished row, for a progress bar.
///
/// # Errors
/// What keeps the core from drawing the view.
pub fn trace<S: Scalar>(
    view: &View<S>,
    settings: Settings<S>,
    size: [u32; 2],
    mut row_done: impl FnMut(u32),
) -> Result<Film<S>, RenderError> {
    let [columns, rows] = size;
    let mut workspace = Workspace::<S, [u8; 2], 0, MAX_DEPTH>::new();
    let canvas = Size::new(columns, rows);
    let mut renderer = Renderer::new(&view.scene, &view.camera, canvas, settings, &mut workspace)?;
    let mut rays = RayCounts::default();
    let mut light = Vec::new();
    for y in 0..rows {
        // The row exists: `y` is below the height the renderer was made with.
        let _ = renderer.trace_row(y, 0..columns, &mut rays, |_, color| light.push(color));
        row_done(y);
    }
    Ok(Film { size, light, rays })
}

/// Is what a panel shows of a picture that was drawn for it, with what it took.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// Red, green and blue of every pixel in 8 bits, row by row from the top.
    pub pixels: Vec<[u8; 3]>,
    /// Rays traced for it.
    pub rays: RayCounts,
}

/// Draws a picture for a panel as a device does: row by row in the panel's levels, in any quality.
///
/// # Errors
/// What keeps the core from drawing the view.
pub fn draw<S: Scalar>(
    view: &View<S>,
    settings: Settings<S, impl Quality>,
    size: [u32; 2],
    panel: Panel,
    row_done: impl FnMut(u32),
) -> Result<Drawn, RenderError> {
    match panel {
        Panel::Rgb565 | Panel::Rgb666 | Panel::Rgb888 => {
            draw_in::<S, false>(view, settings, size, panel, row_done)
        }
        Panel::Gray8 | Panel::Gray4 | Panel::Mono => {
            draw_in::<S, true>(view, settings, size, panel, row_done)
        }
    }
}

fn draw_in<S: Scalar, const GRAY: bool>(
    view: &View<S>,
    settings: Settings<S, impl Quality>,
    size: [u32; 2],
    panel: Panel,
    mut row_done: impl FnMut(u32),
) -> Result<Drawn, RenderError> {
    let [columns, rows] = size;
    let mut workspace = Workspace::<S, Unrounded<GRAY>, 0, MAX_DEPTH>::new();
    let canvas = Size::new(columns, rows);
    let mut renderer = Renderer::new(&view.scene, &view.camera, canvas, settings, &mut workspace)?;
    let mut row = vec![Unrounded::<GRAY>::DARKEST; columns as usize];
    let mut drawn = Drawn { pixels: Vec::new(), rays: RayCounts::default() };
    for y in 0..rows {
        // The row exists, and there is a place for each of its pixels.
        let _ = renderer.watch_row(y, &mut row, &mut drawn.rays);
        drawn.pixels.extend(row.iter().map(|pixel| panel.round(*pixel)));
        row_done(y);
    }
    Ok(drawn)
}

impl<S: Scalar> Film<S> {
    /// Encodes the light for a panel as the core does and answers what the panel shows, in 8 bits
    /// a channel.
    pub fn on_panel(&self, panel: Panel, transfer: Transfer, dither: Dither) -> Vec<[u8; 3]> {
        let columns = self.size[0] as usize;
        let pixel = |(i, light): (usize, &Rgb<S>)| {
            panel.show(*light, transfer, dither, (i % columns) as u32, (i / columns) as u32)
        };
        self.light.iter().enumerate().map(pixel).collect()
    }
}
