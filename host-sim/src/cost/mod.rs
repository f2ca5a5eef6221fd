//! What each pixel costs: rays, shapes asked, operations of the number, as maps of heat and as figures.
//!
//! A picture is traced in a number that counts ([`Tally`]), of shapes that count: the core itself is the one
//! that devices run. Each pixel is traced alone, from left to right; what a row takes once, to find its spans, is
//! left out of its pixels, as are the steps from ray to ray. Instructions come from a chip that is emulated.

mod account;
mod bill;
mod counted;
mod figures;
mod heat;

pub use account::Account;
pub use bill::{Bill, What};
pub use figures::{bars, dearest};
pub use heat::heat;

use crate::growth::Tally;
use crate::picture::MAX_DEPTH;
use crate::rounded::camera_in;
use crate::scene_file::{Description, Unsayable, describe};
use crate::shot::Shot;
use bill::{Stand, Watch};
use counted::Counted;
use embedded_graphics_core::geometry::Size;
use scanray::{Object, RenderError, Renderer, Scene, Settings, Shape, Workspace};
use std::fmt;

/// Is the bills of all pixels of a picture.
#[derive(Clone, Debug)]
pub struct Map {
    /// Columns and rows.
    pub size: [u32; 2],
    /// What each pixel takes, row by row from the top.
    pub pixels: Vec<Bill>,
    /// What each row takes beside its pixels; of instructions, all that it takes.
    pub rows: Vec<Bill>,
}

/// Tells what keeps a picture's cost from being counted.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Uncounted {
    /// The core refuses the picture.
    Core(RenderError),
    /// The scene cannot be had in the number that counts.
    Scene(Unsayable),
}

impl fmt::Display for Uncounted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Core(error) => error.fmt(f),
            Self::Scene(unsayable) => unsayable.fmt(f),
        }
    }
}

impl std::error::Error for Uncounted {}

impl From<RenderError> for Uncounted {
    fn from(error: RenderError) -> Self {
        Self::Core(error)
    }
}

/// Counts what each pixel of a shot takes; `row_done` is told each finished row.
///
/// # Errors
/// What keeps the picture from being drawn in the number that counts.
pub fn count(shot: &Shot, row_done: impl FnMut(u32)) -> Result<Map, Uncounted> {
    let file = shot.scene.file.map(|file| file.drawn().clone());
    let description = file.map_or_else(|| describe(shot.scene.double), Ok).map_err(Uncounted::Scene)?;
    let lists = description.lists::<Tally>();
    let scene = description.scene(&lists);
    let objects: Vec<Object<Tally, Counted>> = scene.objects.iter().map(counted).collect();
    let scene = Scene {
        objects: &objects,
        materials: scene.materials,
        lights: scene.lights,
        sky: scene.sky,
        ambient: scene.ambient,
        hierarchy: scene.hierarchy,
        volume: scene.volume,
    };
    Ok(trace(shot, &scene, settings(&description, shot), row_done)?)
}

impl Map {
    /// Adds what a chip has executed for each pixel alone, and for each row as a whole.
    pub fn charge(&mut self, account: &Account) {
        let charge = |bills: &mut [Bill], counts: &[u64]| {
            bills.iter_mut().zip(counts).for_each(|(bill, count)| bill.instructions = Some(*count));
        };
        charge(&mut self.pixels, &account.pixels);
        charge(&mut self.rows, &account.rows);
    }
}

fn counted(object: &Object<Tally>) -> Object<Tally, Counted> {
    Object::new(Shape::Custom(Counted(object.shape)), object.material)
}

fn settings(description: &Description, shot: &Shot) -> Settings<Tally> {
    description.settings.in_number().with_depth(shot.depth)
}

fn trace(
    shot: &Shot,
    scene: &Scene<'_, Tally, Counted>,
    settings: Settings<Tally>,
    mut row_done: impl FnMut(u32),
) -> Result<Map, RenderError> {
    let [columns, rows] = shot.size;
    let camera = shot.turn.carry(&camera_in(&shot.camera));
    let mut workspace = Workspace::<Tally, [u8; 2], 0, MAX_DEPTH>::new();
    let mut renderer = Renderer::new(scene, &camera, Size::new(columns, rows), settings, &mut workspace)?;
    let mut bill = |columns: std::ops::Range<u32>, y| {
        let (before, mut watch) = (Stand::now(), Watch::default());
        // The row exists: `y` is below the height the renderer was made with.
        let _ = renderer.trace_row(y, columns, &mut watch, |_, _| {});
        before.since(watch)
    };
    let mut map = Map { size: shot.size, pixels: vec![], rows: vec![] };
    for y in 0..rows {
        map.rows.push(bill(0..0, y));
        for x in 0..columns {
            // Rays are found by steps along the row: to begin there takes more at some columns than at others.
            let begun = bill(x..x, y);
            map.pixels.push(bill(x..x + 1, y).without(&begun));
        }
        row_done(y);
    }
    Ok(map)
}
