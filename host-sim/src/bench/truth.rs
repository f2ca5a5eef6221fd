use super::sink::Sink;
use super::{Chip, Failure, SIZE};
use crate::compare::{Comparison, Figures, Subject};
use crate::panel::Panel;
use crate::picture::{self, MAX_DEPTH};
use crate::raster;
use crate::scenes::{Entry, HostNumber};
use crate::shot::{Number, Refusal};
use embedded_graphics_core::geometry::Size;
use embedded_graphics_core::pixelcolor::Rgb565;
use scanray::gallery::View;
use scanray::render::Quality;
use scanray::{
    Adaptive, AtEdges, Exact, Fixed, Jittered, Progress, RasterRenderer, RasterWorkspace, RenderError,
    Renderer, RowError, Settings, Uniform, Workspace,
};

/// Is a scene with the reference's picture of it.
pub struct Truth {
    /// The scene.
    pub scene: Entry,
    reference: Comparison,
}

/// Says what a chip's picture ought to be, and how right that is.
pub struct Judged {
    /// FNV-1a of the bytes for the display's bus.
    pub checksum: u32,
    /// Distance from the reference in 8 bits a channel.
    pub figures: Figures,
}

impl Truth {
    /// Traces a scene with the reference.
    pub fn trace(scene: Entry) -> Result<Self, Failure> {
        let view = scene.double;
        let reference = Comparison::trace(view, view.settings, SIZE, |_| ()).map_err(Refusal::from)?;
        Ok(Self { scene, reference })
    }

    /// Draws the picture as a chip does in a mode, and judges it.
    pub fn judge(&self, chip: &Chip, mode: &str) -> Result<Judged, Failure> {
        match chip.number {
            Number::F32 => self.judge_mode(chip, mode, f32::view(&self.scene)),
            _ => self.judge_mode(chip, mode, Fixed::view(&self.scene)),
        }
    }

    fn judge_mode<S: HostNumber>(&self, chip: &Chip, mode: &str, view: &View<S>) -> Result<Judged, Failure> {
        match mode {
            "raster" => self.judge_rasterized(chip, view),
            "progressive" => self.judge_refined(chip, view),
            "adaptive" => self.judge_in(chip, view, Adaptive),
            "uniform" => self.judge_in(chip, view, Uniform::default()),
            "jittered" => self.judge_in(chip, view, Jittered::default()),
            "at-edges" => self.judge_in(chip, view, AtEdges::<Uniform>::default()),
            _ => self.judge_in(chip, view, Exact),
        }
    }

    /// Judges the z-buffer's picture; the reference has the shadows and mirrors that it lacks.
    fn judge_rasterized<S: HostNumber>(&self, chip: &Chip, view: &View<S>) -> Result<Judged, Failure> {
        let shown = raster::draw(view, SIZE, Panel::Rgb888, |_| ()).map_err(Refusal::from)?;
        let figures = self.figures(chip, view.name, &shown.pixels);
        let mut space = RasterWorkspace::<S, { SIZE[0] as usize }>::new();
        let size = Size::new(SIZE[0], SIZE[1]);
        let renderer = RasterRenderer::new(&view.scene, &view.camera, size, view.settings, &mut space);
        let mut renderer = renderer.map_err(Refusal::from)?;
        Ok(Judged { checksum: checksum_of(1, |y, row| renderer.render_row(y, row)), figures })
    }

    /// Judges a picture that has become finer and finer: in the end it is the exact one.
    fn judge_refined<S: HostNumber>(&self, chip: &Chip, view: &View<S>) -> Result<Judged, Failure> {
        let Judged { figures, .. } = self.judge_in(chip, view, Exact)?;
        let mut space = Workspace::<S, Rgb565, { SIZE[0] as usize }, MAX_DEPTH>::new();
        let settings = view.settings.with_quality(Exact);
        let size = Size::new(SIZE[0], SIZE[1]);
        let renderer = Renderer::new(&view.scene, &view.camera, size, settings, &mut space);
        let mut renderer = renderer.map_err(Refusal::from)?;
        let mut sum = FNV_OFFSET;
        let mut take = |sent: &[[u8; 2]]| sum = fnv(sum, sent);
        let mut sink = Sink::new(size, &mut take);
        let mut progress = Progress::new(16);
        while let Ok(true) = renderer.refine(&mut progress, &mut sink) {}
        Ok(Judged { checksum: sum, figures })
    }

    fn figures(&self, chip: &Chip, scene: &'static str, pixels: &[[u8; 3]]) -> Figures {
        let subject = Subject { scene, number: chip.number.name(), panel: Panel::Rgb888 };
        Figures::of(subject, pixels, &self.reference.on_panel(Panel::Rgb888), &self.reference.mask)
    }

    fn judge_in<S: HostNumber>(
        &self,
        chip: &Chip,
        view: &View<S>,
        quality: impl Quality,
    ) -> Result<Judged, Failure> {
        let settings = view.settings.with_quality(quality);
        let shown = picture::draw(view, settings, SIZE, Panel::Rgb888, |_| ()).map_err(Refusal::from)?;
        let figures = self.figures(chip, view.name, &shown.pixels);
        Ok(Judged { checksum: checksum(view, settings, 1).map_err(Refusal::from)?, figures })
    }
}

/// Answers the checksum of the bytes that a display's bus gets, of each `stride`th row.
pub(super) fn checksum<S: HostNumber>(
    view: &View<S>,
    settings: Settings<S, impl Quality>,
    stride: u32,
) -> Result<u32, RenderError> {
    let [width, height] = SIZE;
    let mut space = Workspace::<S, [u8; 2], 0, MAX_DEPTH>::new();
    let size = Size::new(width, height);
    let mut renderer = Renderer::new(&view.scene, &view.camera, size, settings, &mut space)?;
    Ok(checksum_of(stride, |y, row| renderer.render_row(y, row)))
}

fn checksum_of(stride: u32, mut render_row: impl FnMut(u32, &mut [[u8; 2]]) -> Result<(), RowError>) -> u32 {
    let [width, height] = SIZE;
    let mut row = vec![[0; 2]; width as usize];
    let mut sum = FNV_OFFSET;
    for y in (0..height).step_by(stride as usize) {
        // The row exists and has the picture's width.
        let _ = render_row(y, &mut row);
        sum = fnv(sum, &row);
    }
    sum
}

/// Is where the 32-bit FNV-1a checksum begins.
const FNV_OFFSET: u32 = 0x811c_9dc5;

/// Takes more bytes into the checksum.
fn fnv(sum: u32, sent: &[[u8; 2]]) -> u32 {
    let take = |sum: u32, byte: &u8| (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193);
    sent.as_flattened().iter().fold(sum, take)
}
