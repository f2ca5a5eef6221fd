//! Where the parts of a scene file stand in its text.

use scanray::{CameraError, RenderError, SceneError};
use std::collections::BTreeMap;
use std::ops::Range;

/// Names a part of a scene file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// The columns and rows of the picture.
    Size,
    /// The camera.
    Camera,
    /// The settings.
    Settings,
    /// The sky.
    Sky,
    /// The ambient light.
    Ambient,
    /// A material, by its place in the list.
    Material(usize),
    /// A light, by its place in the list.
    Light(usize),
    /// An object, by its place in the list.
    Object(usize),
    /// The volume.
    Volume,
}

impl Part {
    /// Answers the part that an error of the core is about.
    pub fn of(error: &RenderError) -> Option<Self> {
        Some(match error {
            RenderError::Scene(SceneError::Object(index, _)) => Self::Object(*index),
            RenderError::Scene(SceneError::Material(index, _)) => Self::Material(*index),
            RenderError::Scene(SceneError::Light(index, _)) => Self::Light(*index),
            RenderError::Scene(SceneError::Volume(_)) => Self::Volume,
            RenderError::Scene(SceneError::Sky(_)) => Self::Sky,
            RenderError::Scene(SceneError::Ambient(_)) => Self::Ambient,
            RenderError::Camera(CameraError::BadSize) => Self::Size,
            RenderError::Camera(_) => Self::Camera,
            RenderError::Exposure | RenderError::TooDeep { .. } => Self::Settings,
            _ => return None,
        })
    }
}

/// Holds the bytes of each part that a file has.
pub type Places = BTreeMap<Part, Range<usize>>;
