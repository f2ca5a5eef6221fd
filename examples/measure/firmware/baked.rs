//! The scene whose source the host has baked into the file `SCANRAY_BAKED`.

use super::chosen::Number;
use scanray::{gallery::View, *};

include!(env!("SCANRAY_BAKED"));

/// Is the scene with its camera and settings.
pub static VIEW: View<Number> =
    View { name: "baked", about: "", scene: SCENE, camera: CAMERA, settings: SETTINGS, size: SIZE };
/// Counts the bounces that the scene's rays may take.
pub const DEPTH: usize = SETTINGS.depth as usize;
