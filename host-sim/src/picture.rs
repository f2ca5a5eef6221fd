//! Pictures as the core makes them: linear light of every pixel, and the same on a panel.

use crate::panel::{Panel, Unrounded};
use scanray::gallery::View;
use scanray::math::Scalar;
use scanray::trace::RayCounts;
use scanray::{Dither, Encode, Quality, RenderError, Renderer, Rgb, Settings, Transfer, Workspace};

use embedded_graphics_core::geometry::Size;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::num::NonZeroUsize;
use std::sync::Mutex;

/// Is the most bounces the host's workspaces have room for.
pub const MAX_DEPTH: usize = 32;

/// Is the longest side of a picture that commands and scene files take: no display of the field is larger.
pub const MAX_SIDE: u32 = 4096;

/// Is how many rows a thread takes at a time: enough that to begin costs nothing beside them, few
/// enough that no thread waits long for the last ones.
const BAND: u32 = 8;

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

/// Makes a pool of so many threads, by default one for each core of the processor.
///
/// # Errors
/// What keeps the system from starting them.
pub fn pool(threads: Option<NonZeroUsize>) -> Result<ThreadPool, ThreadPoolBuildError> {
    ThreadPoolBuilder::new().num_threads(threads.map_or(0, NonZeroUsize::get)).build()
}

/// Traces a picture with the core in its number, on all threads of the pool it is called in.
///
/// Rows do not depend on each other: light and ray counts are the same whatever the number of
/// threads. `row_done` is told each finished row, for a progress bar, in the order they are finished.
///
/// # Errors
/// What keeps the core from drawing the view.
pub fn trace<S: Scalar + Send + Sync>(
    view: &View<S>,
    settings: Settings<S, impl Quality + Sync>,
    size: [u32; 2],
    row_done: impl FnMut(u32) + Send,
) -> Result<Film<S>, RenderError> {
    let row_done = Mutex::new(row_done);
    let tell = |y| row_done.lock().map_or((), |mut row_done| row_done(y));
    // A picture without rows is asked for too, so that the core refuses it.
    let tops = (0..size[1].max(1)).into_par_iter().step_by(BAND as usize);
    let bands: Vec<Film<S>> =
        tops.map(|top| trace_band(view, settings, size, top, tell)).collect::<Result<_, _>>()?;
    let rays = bands.iter().fold(RayCounts::default(), |sum, band| RayCounts {
        primary: sum.primary + band.rays.primary,
        shadow: sum.shadow + band.rays.shadow,
        reflection: sum.reflection + band.rays.reflection,
        refraction: sum.refraction + band.rays.refraction,
    });
    Ok(Film { size, light: bands.into_iter().flat_map(|band| band.light).collect(), rays })
}

/// Traces the rows of a picture from `top` on, with a workspace of their own.
fn trace_band<S: Scalar>(
    view: &View<S>,
    settings: Settings<S, impl Quality>,
    [columns, rows]: [u32; 2],
    top: u32,
    row_done: impl Fn(u32),
) -> Result<Film<S>, RenderError> {
    let mut workspace = Workspace::<S, [u8; 2], 0, MAX_DEPTH>::new();
    let canvas = Size::new(columns, rows);
    let mut renderer = Renderer::new(&view.scene, &view.camera, canvas, settings, &mut workspace)?;
    let band = top..rows.min(top + BAND);
    let mut light = Vec::with_capacity(columns as usize * band.len());
    let mut rays = RayCounts::default();
    for y in band.clone() {
        // The row exists: `y` is below the height the renderer was made with.
        let _ = renderer.trace_row(y, 0..columns, &mut rays, |_, color| light.push(color));
        row_done(y);
    }
    Ok(Film { size: [columns, band.len() as u32], light, rays })
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
    if panel.is_gray() {
        draw_in::<S, true>(view, settings, size, panel, row_done)
    } else {
        draw_in::<S, false>(view, settings, size, panel, row_done)
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
        drawn.pixels.extend(panel.round_row(row.iter().map(|pixel| pixel.levels), settings.dither, y));
        row_done(y);
    }
    Ok(drawn)
}

impl<S: Scalar + Sync> Film<S> {
    /// Answers what the panel's channels are to show before they are rounded, as fractions of 2^16.
    pub fn levels(&self, panel: Panel, transfer: Transfer) -> Vec<[u32; 3]> {
        self.light.par_iter().map(|light| panel.levels(*light, transfer)).collect()
    }

    /// Encodes the light for a panel as the core does and answers what the panel shows, in 8 bits
    /// a channel.
    pub fn on_panel(&self, panel: Panel, transfer: Transfer, dither: Dither) -> Vec<[u8; 3]> {
        panel.round(&self.levels(panel, transfer), self.size[0], dither)
    }
}
