//! What is chosen when the firmware is built: scene and number.

use scanray::gallery::View;

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

/// Is the scene with its camera and settings.
pub static VIEW: View<Number> = find(&number::VIEWS, SCENE);
/// Counts the bounces that the scene's rays may take.
pub const DEPTH: usize = find(&number::VIEWS, SCENE).settings.depth as usize;
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
