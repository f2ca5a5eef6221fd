//! The scene of the gallery that is chosen when the firmware is built.

#[cfg(not(target_abi = "eabihf"))]
use scanray::gallery::fixed as number;
#[cfg(target_abi = "eabihf")]
use scanray::gallery::float as number;

use super::chosen::{Number, same};
use scanray::gallery::View;

/// Is the scene's name.
const SCENE: &str = match option_env!("SCANRAY_SCENE") {
    Some(scene) => scene,
    None => "three-spheres",
};

/// Is the scene with its camera and settings.
pub static VIEW: View<Number> = find(number::VIEWS, SCENE);
/// Counts the bounces that the scene's rays may take.
pub const DEPTH: usize = find(number::VIEWS, SCENE).settings.depth as usize;

const fn find(views: &'static [View<Number>], name: &str) -> View<Number> {
    let mut i = 0;
    while !same(views[i].name.as_bytes(), name.as_bytes()) {
        i += 1;
        assert!(i < views.len(), "the gallery has no such scene");
    }
    views[i]
}
