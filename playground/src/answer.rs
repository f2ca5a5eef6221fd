//! What a page is told.

use crate::account::Account;
use scanray::trace::RayCounts;
use serde::Serialize;

/// Is what a page is told, under the name of what it is; pixels are handed over beside it.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Answer {
    /// What there is to choose from.
    Choices(Choices),
    /// The scene that was opened.
    Opened(Opened),
    /// A text: that of a scene, or its source.
    Text(String),
    /// The picture whose pixels are handed over.
    Frame(Frame),
    /// The rays of each pixel, as a picture whose pixels are handed over.
    Heat(Heat),
    /// What a pixel is.
    Pixel(Account),
    /// How many bytes a file has that was taken.
    Taken(usize),
    /// What keeps the request from being done.
    Fault(String),
}

/// Lists what there is to choose from, so that a page has no list of its own.
#[derive(Clone, Debug, Serialize)]
pub struct Choices {
    /// Names of the gallery's scenes.
    pub scenes: Vec<&'static str>,
    /// Numbers, and the reference.
    pub numbers: Vec<&'static str>,
    /// Those of them that firmware computes in.
    pub of_firmware: Vec<&'static str>,
    /// Who may draw.
    pub approaches: Vec<&'static str>,
    /// Colour formats of displays.
    pub panels: Vec<&'static str>,
    /// Ways to trace a picture.
    pub qualities: Vec<&'static str>,
    /// Ways to round levels.
    pub dithers: Vec<&'static str>,
    /// The most pixels along a side.
    pub most_pixels: u32,
    /// The most bytes of files together.
    pub most_bytes: u64,
    /// The most mirrors.
    pub most_depth: usize,
    /// The most rays along a side of a pixel.
    pub most_rays: u8,
    /// Parts of a step of a walk, parts of a walk around, notches of a zoom.
    pub walk: [i32; 3],
    /// Red, green and blue of few rays to many.
    pub heat: Vec<[u8; 3]>,
}

/// Is a scene that was opened.
#[derive(Clone, Debug, Serialize)]
pub struct Opened {
    /// Its name.
    pub name: &'static str,
    /// What it shows.
    pub about: &'static str,
    /// The name of the file that its text is.
    pub file: String,
    /// What of its file is left out or drawn otherwise.
    pub notes: Vec<String>,
    /// Columns and rows of its usual picture.
    pub size: [u32; 2],
    /// How many mirrors its light may have met.
    pub depth: u8,
    /// How its levels are rounded.
    pub dither: &'static str,
    /// How many parts of a step one can walk down and up.
    pub reach: [i32; 2],
}

/// Is a picture.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Frame {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Rays from the eye, to lights, into mirrors, through glass; none are counted for the reference.
    pub rays: Option<[u64; 4]>,
    /// Depths that the z-buffer has tested, if it drew the picture.
    pub fragments: Option<u64>,
}

/// Is the rays of each pixel.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Heat {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Rays of the pixel that takes the fewest, and of the one that takes the most.
    pub range: [u64; 2],
    /// Rays of all pixels together.
    pub total: u64,
}

/// Answers rays by kind.
pub fn by_kind(rays: RayCounts) -> [u64; 4] {
    [rays.primary, rays.shadow, rays.reflection, rays.refraction]
}
