//! What is chosen when the firmware is built: scene, number and mode.

use scanray::{Adaptive, Exact, gallery::View, render::Quality};

#[cfg(not(target_abi = "eabihf"))]
use scanray::gallery::fixed as number;
#[cfg(target_abi = "eabihf")]
use scanray::gallery::float as number;

/// Is the number that suits the chip.
#[cfg(target_abi = "eabihf")]
pub type Number = f32;
/// Is the number that suits the chip.
#[cfg(not(target_abi = "eabihf"))]
pub type Number = scanray::Fixed;

/// Is the scene's name.
const SCENE: &str = match option_env!("SCANRAY_SCENE") {
    Some(scene) => scene,
    None => "three-spheres",
};

/// Is the mode's name, as tables show it.
pub const MODE: &str = match option_env!("SCANRAY_MODE") {
    Some(mode) => mode,
    None => "exact",
};

/// Is the mode as a type: an image holds the code of its own mode only.
pub type Mode = <Is<{ is_adaptive() }> as Chosen>::Mode;

/// Stands for a yes or a no.
pub struct Is<const YES: bool>;

/// Names the type that an answer stands for.
pub trait Chosen {
    /// Is that type.
    type Mode: Quality;
}

impl Chosen for Is<false> {
    type Mode = Exact;
}

impl Chosen for Is<true> {
    type Mode = Adaptive;
}

const _: () = assert!(RASTER || is_mode(b"adaptive") || is_mode(b"exact"), "there is no such mode");

const fn is_adaptive() -> bool {
    is_mode(b"adaptive")
}

/// Tells whether the z-buffer draws, not the tracer.
pub const RASTER: bool = is_mode(b"raster");

const fn is_mode(name: &[u8]) -> bool {
    same(MODE.as_bytes(), name)
}

/// Is the scene with its camera and settings.
pub static VIEW: View<Number> = find(number::VIEWS, SCENE);
/// Counts the bounces that the scene's rays may take.
pub const DEPTH: usize = find(number::VIEWS, SCENE).settings.depth as usize;
/// Counts the picture's columns.
pub const WIDTH: u32 = 320;
/// Counts the picture's rows.
pub const HEIGHT: u32 = 240;

const fn find(views: &'static [View<Number>], name: &str) -> View<Number> {
    let mut i = 0;
    while !same(views[i].name.as_bytes(), name.as_bytes()) {
        i += 1;
        assert!(i < views.len(), "the gallery has no such scene");
    }
    views[i]
}

const fn same(a: &[u8], b: &[u8]) -> bool {
    let mut i = 0;
    while i < a.len() && i < b.len() && a[i] == b[i] {
        i += 1;
    }
    i == a.len() && i == b.len()
}
