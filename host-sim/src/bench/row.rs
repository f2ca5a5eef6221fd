use super::emulator::Said;
use super::image::Sizes;
use super::truth::Judged;
use super::{Chip, Failure, SIZE};
use serde::{Deserialize, Serialize};

/// Says what a picture of a scene costs on a chip, and how right it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The scene's name.
    pub scene: String,
    /// The chip's name.
    pub chip: String,
    /// The number it computes in.
    pub number: String,
    /// How the picture is made.
    pub mode: String,
    /// Executed instructions a pixel, of the whole frame with encoding.
    pub instr_per_px: f64,
    /// Cycles a pixel, of the same, where they are known: instructions times the cycles of one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cycles_per_px: Option<f64>,
    /// Bytes of the whole image in flash.
    pub text_bytes: u64,
    /// Bytes of statics in RAM.
    pub ram_bytes: u64,
    /// Bytes of the stack at its deepest; workspace and row lie there.
    pub stack_bytes: u64,
    /// Peak signal-to-noise ratio in dB away from silhouettes.
    pub psnr_db: f64,
    /// The same of the whole picture.
    #[serde(skip)]
    pub psnr_all_db: f64,
    /// Tells that the cycles of an instruction were counted in each so manieth row.
    #[serde(skip)]
    pub stride: u32,
}

fn round(value: f64, digits: i32) -> f64 {
    let unit = 10_f64.powi(digits);
    (value * unit).round() / unit
}

impl Row {
    /// Gathers what is known of a picture.
    pub(super) fn new(
        chip: &Chip,
        scene: &str,
        mode: &str,
        sizes: Sizes,
        said: &Said,
        judged: &Judged,
    ) -> Result<Self, Failure> {
        let pixels = f64::from(SIZE[0]) * f64::from(SIZE[1]);
        Ok(Self {
            scene: scene.to_owned(),
            chip: chip.name.to_owned(),
            number: chip.number.name().to_owned(),
            mode: mode.to_owned(),
            instr_per_px: round(said.count(mode)? as f64 / pixels, 1),
            cycles_per_px: None,
            text_bytes: sizes.flash,
            ram_bytes: sizes.ram,
            stack_bytes: said.figure(mode, "stack")?.into(),
            psnr_db: round(judged.figures.psnr_db, 2),
            psnr_all_db: round(judged.figures.psnr_all_db, 2),
            stride: 1,
        })
    }

    /// Adds the cycles, of which an instruction takes so many in each `stride`th row.
    pub(super) fn set_cycles(&mut self, an_instruction: f64, stride: u32) {
        self.cycles_per_px = Some(round(self.instr_per_px * an_instruction, 1));
        self.stride = stride;
    }

    /// Tells whether two rows are of the same picture.
    pub fn is_of(&self, other: &Self) -> bool {
        [&self.scene, &self.chip, &self.number, &self.mode]
            == [&other.scene, &other.chip, &other.number, &other.mode]
    }
}
