//! Pictures that become finer step by step, as a panel shows them.

use crate::panel::{Panel, Unrounded};
use crate::picture::MAX_DEPTH;
use crate::scenes::HostNumber;
use crate::shot::{Approach, Number, Picture, Quality, Refusal, Sampling, Shot};
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
use scanray::gallery::View;
use scanray::output::Rounding;
use scanray::render::Pointwise;
use scanray::trace::RayCounts;
use scanray::{Dither, Exact, Fixed, Jittered, Progress, Renderer, Settings, Uniform, Workspace};
use std::convert::Infallible;
use std::ops::Range;

/// Is the widest picture that becomes finer step by step.
pub const MAX_WIDTH: usize = 4096;

/// Is what a panel shows after a step.
#[derive(Clone, Debug)]
pub struct Step<'p> {
    /// The whole picture.
    pub picture: &'p Picture,
    /// The rows that the step has drawn in.
    pub rows: Range<u32>,
    /// The side of the blocks it has drawn.
    pub side: u8,
    /// The rays it has traced, and those before it.
    pub rays: RayCounts,
}

/// Is a panel of which one sees what it shows.
struct Glass {
    panel: Panel,
    dither: Dither,
    picture: Picture,
}

/// Sees the glass as a display of the colours that one kind of panel rounds.
struct Display<'g, const GRAY: bool>(&'g mut Glass);

impl<const GRAY: bool> OriginDimensions for Display<'_, GRAY> {
    fn size(&self) -> Size {
        Size::new(self.0.picture.size[0], self.0.picture.size[1])
    }
}

impl<const GRAY: bool> DrawTarget for Display<'_, GRAY> {
    type Color = Unrounded<GRAY>;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Self::Color>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let Glass { panel, dither, picture } = &mut *self.0;
        for Pixel(Point { x, y }, color) in pixels {
            let place = y as usize * picture.size[0] as usize + x as usize;
            if let Some(pixel) = picture.pixels.get_mut(place) {
                *pixel = panel.round_pixel(x as u32, color.levels, &mut Rounding::of_row(*dither, y as u32));
            }
        }
        Ok(())
    }
}

impl Shot {
    /// Draws the picture in blocks of `block` pixels along a side, then in smaller ones, down to pixels; each
    /// step is told.
    ///
    /// # Errors
    /// What keeps it from being drawn, or from being drawn so.
    pub fn refine(&self, block: u8, step_done: impl FnMut(Step<'_>)) -> Result<(), Refusal> {
        if self.approach == Approach::Raster {
            return Err(Refusal::NotProgressive);
        }
        match self.number {
            Number::F32 => self.refine_in::<f32>(block, step_done),
            Number::Fixed => self.refine_in::<Fixed>(block, step_done),
            Number::Exact => self.refine_in::<f64>(block, step_done),
            Number::Oracle => Err(Refusal::NotProgressive),
        }
    }

    fn refine_in<S: HostNumber>(&self, block: u8, step_done: impl FnMut(Step<'_>)) -> Result<(), Refusal> {
        let view = &self.view::<S>();
        match self.quality {
            Quality::Exact => self.refine_view(view, Exact, block, step_done),
            Quality::Sampled(Sampling { side, jittered: false, at_edges: false }) => {
                self.refine_view(view, Uniform(side), block, step_done)
            }
            Quality::Sampled(Sampling { side, jittered: true, at_edges: false }) => {
                self.refine_view(view, Jittered(side), block, step_done)
            }
            Quality::Adaptive | Quality::Sampled(_) => Err(Refusal::NotProgressive),
        }
    }

    fn refine_view<S: HostNumber>(
        &self,
        view: &View<S>,
        quality: impl Pointwise,
        block: u8,
        step_done: impl FnMut(Step<'_>),
    ) -> Result<(), Refusal> {
        let settings = view.settings.with_quality(quality);
        // The core rounds each pixel by itself here, as the glass does.
        let dither = if self.dither == Dither::Diffused { Dither::Ordered } else { self.dither };
        let glass = Glass { panel: self.panel, dither, picture: Picture::filled(self.size, [0; 3]) };
        if self.panel.is_gray() {
            refine_on::<S, true>(view, settings, glass, block, step_done)
        } else {
            refine_on::<S, false>(view, settings, glass, block, step_done)
        }
    }
}

fn refine_on<S: HostNumber, const GRAY: bool>(
    view: &View<S>,
    settings: Settings<S, impl Pointwise>,
    mut glass: Glass,
    block: u8,
    mut step_done: impl FnMut(Step<'_>),
) -> Result<(), Refusal> {
    let mut workspace = Workspace::<S, Unrounded<GRAY>, MAX_WIDTH, MAX_DEPTH>::new();
    let [columns, height] = glass.picture.size;
    let canvas = Size::new(columns, height);
    let mut renderer = Renderer::new(&view.scene, &view.camera, canvas, settings, &mut workspace)?;
    let (mut progress, mut rays) = (Progress::new(block), RayCounts::default());
    while !progress.is_complete() {
        let (Range { start, end }, side) = (progress.rows(), progress.side());
        let mut display = Display::<GRAY>(&mut glass);
        let Ok(_) = renderer.watch_refining(&mut progress, Point::zero(), &mut display, &mut rays);
        step_done(Step { picture: &glass.picture, rows: start..end.min(height), side, rays });
    }
    Ok(())
}
