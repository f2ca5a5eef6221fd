//! The images of the gallery, computed: `cargo run -p host-sim --example images` writes them.
//!
//! The core includes the files as they are, so that firmware has them in flash; a test tells whether
//! they are what is computed here.

mod head;
mod letters;
mod noise;
mod reliefs;
mod sky;
mod world;

use letters::{letters, pavement};

/// Is the name of a file of `src/gallery/images` and its bytes, row by row from the top.
pub type File = (&'static str, Vec<u8>);

/// Computes all images.
pub fn all() -> Vec<File> {
    let mut files = vec![
        ("letters_32x32.rgb565", letters()),
        ("pavement_8x8.rgb565", picture([8, 8], pavement)),
        ("world_96x48.rgb565", picture([96, 48], world::color)),
        ("craters_96x48.gray8", relief([96, 48], reliefs::craters)),
        ("peel_32x32.gray8", relief([32, 32], reliefs::peel)),
        ("dimples_16x16.rgb888", reliefs::dimples(16)),
        ("head_48x60x56.voxels", head::voxels()),
        ("head_48x60x56.blocks", head::blocks()),
    ];
    files.extend(
        sky::FACES
            .iter()
            .zip(sky::NAMES)
            .map(|(face, name)| (name, picture([32, 32], |u, v| sky::color(face(u, v))))),
    );
    files
}

/// Answers the bytes of `Rgb565` of sRGB levels from 0 to 1, the high byte first.
fn rgb565([r, g, b]: [f64; 3]) -> [u8; 2] {
    let step = |level: f64, top: f64| (level.clamp(0.0, 1.0) * top).round() as u16;
    (step(r, 31.0) << 11 | step(g, 63.0) << 5 | step(b, 31.0)).to_be_bytes()
}

/// Lists u and v of all texels: 0 to 1 from the leftmost to the rightmost, and from the lowest row up.
fn places([columns, rows]: [u32; 2]) -> impl Iterator<Item = [f64; 2]> {
    let share = |i: u32, count: u32| f64::from(i) / f64::from(count - 1);
    (0..rows).flat_map(move |y| (0..columns).map(move |x| [share(x, columns), 1.0 - share(y, rows)]))
}

fn picture(size: [u32; 2], color: impl Fn(f64, f64) -> [f64; 3]) -> Vec<u8> {
    places(size).flat_map(|[u, v]| rgb565(color(u, v))).collect()
}

fn relief(size: [u32; 2], height: impl Fn(f64, f64) -> f64) -> Vec<u8> {
    places(size).map(|[u, v]| (height(u, v).clamp(0.0, 1.0) * 255.0).round() as u8).collect()
}

/// Answers the direction from the middle of a ball that texture coordinates name: u eastward, v up.
fn on_ball(u: f64, v: f64) -> [f64; 3] {
    let (phi, theta) = ((1.0 - u) * std::f64::consts::TAU, (1.0 - v) * std::f64::consts::PI);
    [theta.sin() * phi.cos(), theta.cos(), theta.sin() * phi.sin()]
}
