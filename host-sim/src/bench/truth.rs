use super::{Chip, Failure, SIZE};
use crate::compare::{Comparison, Figures, Subject};
use crate::panel::Panel;
use crate::picture::{self, MAX_DEPTH};
use crate::scenes::{Entry, HostNumber};
use crate::shot::{Number, Refusal};
use embedded_graphics_core::geometry::Size;
use scanray::gallery::View;
use scanray::render::Quality;
use scanray::{Adaptive, Exact, Fixed, RenderError, Renderer, Settings, Workspace};

/// Names the modes that the firmware measures.
pub const MODES: [&str; 2] = ["exact", "adaptive"];

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
        match (chip.number, mode == "adaptive") {
            (Number::F32, false) => self.judge_in(chip, f32::view(&self.scene), Exact),
            (Number::F32, true) => self.judge_in(chip, f32::view(&self.scene), Adaptive),
            (_, false) => self.judge_in(chip, Fixed::view(&self.scene), Exact),
            (_, true) => self.judge_in(chip, Fixed::view(&self.scene), Adaptive),
        }
    }

    fn judge_in<S: HostNumber>(
        &self,
        chip: &Chip,
        view: &View<S>,
        quality: impl Quality,
    ) -> Result<Judged, Failure> {
        let settings = view.settings.with_quality(quality);
        let shown = picture::draw(view, settings, SIZE, Panel::Rgb888, |_| ()).map_err(Refusal::from)?;
        let subject = Subject { scene: view.name, number: chip.number.name(), panel: Panel::Rgb888 };
        let reference = self.reference.on_panel(Panel::Rgb888);
        let figures = Figures::of(subject, &shown.pixels, &reference, &self.reference.mask);
        Ok(Judged { checksum: checksum(view, settings).map_err(Refusal::from)?, figures })
    }
}

/// Answers the checksum of the bytes that a display's bus gets.
fn checksum<S: HostNumber>(view: &View<S>, settings: Settings<S, impl Quality>) -> Result<u32, RenderError> {
    let [width, height] = SIZE;
    let mut space = Workspace::<S, [u8; 2], 0, MAX_DEPTH>::new();
    let size = Size::new(width, height);
    let mut renderer = Renderer::new(&view.scene, &view.camera, size, settings, &mut space)?;
    let mut row = vec![[0; 2]; width as usize];
    let mut sum = 0x811c_9dc5_u32;
    for y in 0..height {
        // The row exists and has the picture's width.
        let _ = renderer.render_row(y, &mut row);
        let take = |sum: u32, byte: &u8| (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193);
        sum = row.as_flattened().iter().fold(sum, take);
    }
    Ok(sum)
}
