//! What is chosen when the firmware is built: number and mode.

use scanray::{Adaptive, AtEdges, Exact, Jittered, Uniform, render::Quality};

/// Is the number that suits the chip.
#[cfg(target_abi = "eabihf")]
pub type Number = f32;
/// Is the number that suits the chip.
#[cfg(not(target_abi = "eabihf"))]
pub type Number = scanray::Fixed;

/// Is the mode's name, as tables show it.
pub const MODE: &str = match option_env!("SCANRAY_MODE") {
    Some(mode) => mode,
    None => "exact",
};

/// Names the modes; their numbers are their places here.
const MODES: [&str; 8] =
    ["exact", "adaptive", "uniform", "jittered", "at-edges", "raster", "progressive", "account"];

/// Is the mode's number.
const NUMBER: usize = place(&MODES, MODE);

/// Tells whether the z-buffer draws, not the tracer.
pub const RASTER: bool = NUMBER == 5;

/// Tells whether the picture becomes finer and finer.
pub const PROGRESSIVE: bool = NUMBER == 6;

/// Tells whether rows and pixels are measured one by one, not the picture as a whole.
pub const ACCOUNT: bool = NUMBER == 7;

/// Is the mode as a type: an image holds the code of its own mode only. Those of several rays a pixel take
/// the 2x2 that are their default.
pub type Mode = <Numbered<NUMBER> as Chosen>::Mode;

/// Stands for a mode.
pub struct Numbered<const NUMBER: usize>;

/// Names the quality that a mode stands for.
pub trait Chosen {
    /// Is that type.
    type Mode: Quality;
}

macro_rules! chosen {
    ($($number:literal => $mode:ty,)*) => {$(
        impl Chosen for Numbered<$number> {
            type Mode = $mode;
        }
    )*};
}

chosen! {
    0 => Exact,
    1 => Adaptive,
    2 => Uniform,
    3 => Jittered,
    4 => AtEdges<Uniform>,
    5 => Exact,
    6 => Exact,
    7 => Exact,
}

const fn place(names: &[&str], name: &str) -> usize {
    let mut i = 0;
    while !same(names[i].as_bytes(), name.as_bytes()) {
        i += 1;
        assert!(i < names.len(), "there is no such mode");
    }
    i
}

/// Counts the picture's columns.
pub const WIDTH: u32 = 320;
/// Counts the picture's rows.
pub const HEIGHT: u32 = 240;

/// Tells whether two names are the same.
pub const fn same(a: &[u8], b: &[u8]) -> bool {
    let mut i = 0;
    while i < a.len() && i < b.len() && a[i] == b[i] {
        i += 1;
    }
    i == a.len() && i == b.len()
}
