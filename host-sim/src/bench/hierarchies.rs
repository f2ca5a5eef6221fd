//! What each kind of hierarchy costs on a chip, over the triangles of the teapot.

use super::image::Image;
use super::truth::checksum;
use super::{Chip, Failure, SIZE, emulator};
use crate::bake::source::{Literal, Planted};
use crate::bake::{Accel, meshes};
use crate::scenes::Entry;
use crate::shot::{Number, Refusal};
use scanray::gallery::{double, fixed, float};
use scanray::{Exact, Fixed};
use std::time::{Duration, Instant};

/// Is the scene whose mesh gets every kind.
static TEAPOT: Entry =
    Entry { float: &float::TEAPOT, fixed: &fixed::TEAPOT, double: &double::TEAPOT, file: None };

/// Says what a hierarchy costs.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// The kind.
    pub accel: Accel,
    /// Bytes in flash, for each triangle.
    pub bytes_each: f64,
    /// Executed instructions a pixel, all that the picture takes.
    pub instr_per_px: f64,
    /// Bytes of the whole image in flash.
    pub flash: u64,
    /// How many rows of the picture were counted.
    pub rows: u32,
    /// How long it took to build on this computer.
    pub build: Duration,
}

/// Measures a kind of hierarchy on a chip, in the number that suits it.
///
/// # Errors
/// What keeps the image from being built or run, or a picture that is not the host's.
pub fn cost(chip: &Chip, accel: Accel) -> Result<Cost, Failure> {
    match chip.number {
        Number::F32 => cost_in::<f32>(chip, accel),
        _ => cost_in::<Fixed>(chip, accel),
    }
}

fn cost_in<S: Literal>(chip: &Chip, accel: Accel) -> Result<Cost, Failure> {
    let view = *S::view(&TEAPOT);
    let begun = Instant::now();
    let grown = meshes::grow(&view, TEAPOT.double, accel);
    let build = begun.elapsed();
    let source = Planted { view, grown, tree: None }.write()?;
    let image = Image::build_baked(chip, &source, &TEAPOT.double.scene, MODE)?;
    let stride = stride(accel);
    let said = emulator::count_instructions(chip, &image, stride)?;
    let drawn = checksum(&view, view.settings.with_quality(Exact), stride).map_err(Refusal::from)?;
    if said.figure(MODE, "checksum")? != drawn {
        return Err(Failure::OtherPicture(format!("{} by {}", view.name, accel.name()), chip.name));
    }
    let rows = SIZE[1].div_ceil(stride);
    let pixels = f64::from(SIZE[0]) * f64::from(rows);
    Ok(Cost {
        accel,
        bytes_each: source.bill.hierarchies as f64 / source.bill.triangle_count as f64,
        instr_per_px: said.count(MODE)? as f64 / pixels,
        flash: image.sizes()?.flash,
        rows,
        build,
    })
}

/// Is the mode in which a baked scene is drawn.
const MODE: &str = "exact";

/// Answers how far apart the rows lie that are counted: they stand for the picture within a percent. Asking
/// every triangle takes a hundred times as long, millions of instructions a pixel.
fn stride(accel: Accel) -> u32 {
    match accel {
        Accel::None => 48,
        Accel::Bvh | Accel::Kd | Accel::Octree | Accel::Grid => 4,
    }
}
