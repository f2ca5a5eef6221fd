use std::fmt;

/// Names the thing of a scene that cannot be written as source: code of the user's own, a kind that is newer
/// than this, a mesh whose hierarchy was not made here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unwritable {
    /// An object.
    Object(usize),
    /// A material.
    Material(usize),
    /// A light.
    Light(usize),
    /// The sky.
    Sky,
    /// The camera.
    Camera,
    /// The settings.
    Settings,
}

impl fmt::Display for Unwritable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Object(index) => write!(f, "object {index}"),
            Self::Material(index) => write!(f, "material {index}"),
            Self::Light(index) => write!(f, "light {index}"),
            Self::Sky => f.write_str("the sky"),
            Self::Camera => f.write_str("the camera"),
            Self::Settings => f.write_str("the settings"),
        }?;
        f.write_str(" cannot be written as source: it is code, or a kind that this program does not know")
    }
}

impl std::error::Error for Unwritable {}
