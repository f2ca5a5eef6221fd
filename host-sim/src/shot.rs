//! Shots: all that decides a picture, with the number chosen at run time.

use crate::compare::{Comparison, Figures, Subject};
use crate::panel::Panel;
use crate::picture::{self, Drawn};
use crate::raster;
use crate::reference::Unknown;
use crate::rounded::camera_in;
use crate::scenes::{Entry, HostNumber};
use crate::turn::Turn;
use scanray::gallery::View;
use scanray::trace::RayCounts;
use scanray::{Adaptive, AtEdges, Camera, Dither, Exact, Fixed, Jittered, RenderError, Transfer, Uniform};
use std::fmt;
use std::time::{Duration, Instant};

/// Names who traces a picture, and in which number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// The core in `f32`.
    F32,
    /// The core in fixed point.
    Fixed,
    /// The core in `f64`.
    Exact,
    /// The reference, which shares no code with the core.
    Oracle,
}

impl Number {
    /// Lists all.
    pub const ALL: [Self; 4] = [Self::F32, Self::Fixed, Self::Exact, Self::Oracle];

    /// Answers the name, as commands take it.
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::Fixed => "fixed",
            Self::Exact => "exact",
            Self::Oracle => "oracle",
        }
    }
}

/// Names how much of a picture is traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quality {
    /// Every pixel.
    Exact,
    /// Not what lies between pixels that see the same.
    Adaptive,
    /// Every pixel, or those on edges, by several rays.
    Sampled(Sampling),
}

/// Is how several rays go through a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// Rays along a side of the pixel: their number is the square of it.
    pub side: u8,
    /// Whether they are scattered.
    pub jittered: bool,
    /// Whether only pixels on edges take several.
    pub at_edges: bool,
}

impl Quality {
    /// Answers how many rays along a side of a pixel the picture is an approximation of.
    fn side(self) -> u8 {
        match self {
            Self::Exact | Self::Adaptive => 1,
            Self::Sampled(Sampling { side, .. }) => side,
        }
    }
}

/// Names who draws a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Approach {
    /// The ray tracer.
    Trace,
    /// The z-buffer.
    Raster,
}

impl Approach {
    /// Lists all.
    pub const ALL: [Self; 2] = [Self::Trace, Self::Raster];

    /// Answers the name, as commands take it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Trace => "trace",
            Self::Raster => "raster",
        }
    }
}

/// Is all that decides a picture.
#[derive(Clone, Copy, Debug)]
pub struct Shot {
    /// What there is to see.
    pub scene: Entry,
    /// Where it is seen from, before the turn.
    pub camera: Camera<f64>,
    /// How far the camera is carried around.
    pub turn: Turn,
    /// Who traces it.
    pub number: Number,
    /// Columns and rows.
    pub size: [u32; 2],
    /// The colour format it is shown in.
    pub panel: Panel,
    /// How many mirrors light may have met.
    pub depth: u8,
    /// How light becomes levels.
    pub transfer: Transfer,
    /// How levels are rounded.
    pub dither: Dither,
    /// How much of it is traced.
    pub quality: Quality,
    /// Who draws it; there is one reference for both.
    pub approach: Approach,
}

/// Is a picture as a panel shows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Red, green and blue of each pixel, row by row from the top.
    pub pixels: Vec<[u8; 3]>,
}

/// Is a picture with what was counted for it.
#[derive(Clone, Debug)]
pub struct Counted {
    /// The picture.
    pub picture: Picture,
    /// Rays by kind; none are counted for the reference.
    pub rays: Option<RayCounts>,
    /// Depths that the z-buffer has tested, if it drew the picture.
    pub fragments: Option<u64>,
}

/// Is a picture with what it took.
#[derive(Clone, Debug)]
pub struct Taken {
    /// The picture.
    pub picture: Picture,
    /// Rays by kind; none are counted for the reference.
    pub rays: Option<RayCounts>,
    /// Depths that the z-buffer has tested, if it drew the picture.
    pub fragments: Option<u64>,
    /// How long the tracing took.
    pub time: Duration,
}

impl Shot {
    /// Makes the shot the gallery shows of a scene: `f32` on an Rgb565 panel.
    pub fn new(scene: Entry) -> Self {
        let view = scene.double;
        Self {
            scene,
            camera: view.camera,
            turn: Turn::NONE,
            number: Number::F32,
            size: view.size,
            panel: Panel::Rgb565,
            depth: view.settings.depth,
            transfer: view.settings.transfer,
            dither: view.settings.dither,
            quality: Quality::Exact,
            approach: Approach::Trace,
        }
    }

    /// Traces the picture; `row_done` is told each finished row.
    ///
    /// # Errors
    /// What keeps it from being drawn.
    pub fn take(&self, row_done: impl FnMut(u32) + Send) -> Result<Taken, Refusal> {
        let begin = Instant::now();
        let Counted { picture, rays, fragments } = self.draw(row_done)?;
        Ok(Taken { picture, rays, fragments, time: begin.elapsed() })
    }

    /// Traces the picture where there may be no clock.
    ///
    /// # Errors
    /// What keeps it from being drawn.
    pub fn draw(&self, row_done: impl FnMut(u32) + Send) -> Result<Counted, Refusal> {
        match self.number {
            Number::F32 => self.draw_in::<f32>(row_done),
            Number::Fixed => self.draw_in::<Fixed>(row_done),
            Number::Exact => self.draw_in::<f64>(row_done),
            Number::Oracle => self.draw_reference(row_done),
        }
    }

    /// Traces the picture with the reference, to judge pictures of this shot by.
    ///
    /// # Errors
    /// What keeps it from being drawn.
    pub fn reference(&self, row_done: impl FnMut(u32) + Send) -> Result<Comparison, Refusal> {
        let view = self.view::<f64>();
        // The reference leaves the check of what it is given to the core.
        view.scene.check().map_err(RenderError::from)?;
        view.camera.frame(self.size[0], self.size[1]).map_err(RenderError::from)?;
        let side = u32::from(self.quality.side());
        Ok(Comparison::trace_samples(&view, view.settings, self.size, side, row_done)?)
    }

    /// Judges a picture of this shot.
    pub fn judge(&self, picture: &Picture, reference: &Comparison) -> Figures {
        let subject = Subject { scene: self.scene.name(), number: self.number.name(), panel: self.panel };
        Figures::of(subject, &picture.pixels, &reference.on_panel(self.panel), &reference.mask)
    }

    /// Answers the gallery's view with what this shot changes of it.
    pub fn view<S: HostNumber>(&self) -> View<S> {
        let mut view = *S::view(&self.scene);
        view.camera = self.turn.carry(&camera_in(&self.camera));
        let Self { depth, transfer, dither, .. } = *self;
        view.settings = view.settings.with_depth(depth).with_transfer(transfer).with_dither(dither);
        view
    }

    fn draw_in<S: HostNumber>(&self, row_done: impl FnMut(u32)) -> Result<Counted, Refusal> {
        let view = self.view::<S>();
        if self.approach == Approach::Raster {
            let drawn = raster::draw(&view, self.size, self.panel, row_done)?;
            let picture = Picture { size: self.size, pixels: drawn.pixels };
            return Ok(Counted { picture, rays: None, fragments: Some(drawn.fragments) });
        }
        let drawn = self.trace(&view, row_done)?;
        let picture = Picture { size: self.size, pixels: drawn.pixels };
        Ok(Counted { picture, rays: Some(drawn.rays), fragments: None })
    }

    fn trace<S: HostNumber>(&self, view: &View<S>, row_done: impl FnMut(u32)) -> Result<Drawn, RenderError> {
        match self.quality {
            Quality::Exact => self.trace_by(view, Exact, row_done),
            Quality::Adaptive => self.trace_by(view, Adaptive, row_done),
            Quality::Sampled(Sampling { side, jittered, at_edges }) => match (jittered, at_edges) {
                (false, false) => self.trace_by(view, Uniform(side), row_done),
                (true, false) => self.trace_by(view, Jittered(side), row_done),
                (false, true) => self.trace_by(view, AtEdges(Uniform(side)), row_done),
                (true, true) => self.trace_by(view, AtEdges(Jittered(side)), row_done),
            },
        }
    }

    fn trace_by<S: HostNumber>(
        &self,
        view: &View<S>,
        quality: impl scanray::Quality,
        row_done: impl FnMut(u32),
    ) -> Result<Drawn, RenderError> {
        picture::draw(view, view.settings.with_quality(quality), self.size, self.panel, row_done)
    }

    fn draw_reference(&self, row_done: impl FnMut(u32) + Send) -> Result<Counted, Refusal> {
        let pixels = self.reference(row_done)?.on_panel(self.panel);
        Ok(Counted { picture: Picture { size: self.size, pixels }, rays: None, fragments: None })
    }
}

/// Tells what keeps a picture from being drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Refusal {
    /// The core refuses it.
    Core(RenderError),
    /// The reference has no formula for it.
    Reference(Unknown),
    /// It cannot become finer step by step: it is the reference's or the z-buffer's, or its pixels depend on
    /// each other.
    NotProgressive,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Core(error) => error.fmt(f),
            Self::Reference(error) => error.fmt(f),
            Self::NotProgressive => f.write_str(
                "only the tracer's pictures whose pixels do not depend on each other become finer step by step",
            ),
        }
    }
}

impl std::error::Error for Refusal {}

impl From<RenderError> for Refusal {
    fn from(error: RenderError) -> Self {
        Self::Core(error)
    }
}

impl From<Unknown> for Refusal {
    fn from(error: Unknown) -> Self {
        Self::Reference(error)
    }
}
