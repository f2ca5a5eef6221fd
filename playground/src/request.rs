//! What a page asks for.

use crate::look::Look;
use serde::Deserialize;

/// Is what a page asks for.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "ask", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Request {
    /// What there is to choose from.
    Choices,
    /// To open a scene of the gallery.
    Open {
        /// Its name.
        name: String,
    },
    /// To take the file that lies at the door, for scenes that name it.
    Take {
        /// Its name.
        name: String,
    },
    /// To open a scene file or a model that was taken.
    Read {
        /// Its name.
        name: String,
    },
    /// To open a scene that is told in text, in the format of `docs/scene-format.md` or, by the file's name, in NFF.
    Write {
        /// The text.
        text: String,
        /// The file that it is the text of, beside those that were taken.
        #[serde(default)]
        file: Option<String>,
        /// A scene of the gallery or a model that was taken: the text may name its images, meshes and voxels.
        #[serde(default)]
        of: Option<String>,
    },
    /// The text of the open scene.
    Text,
    /// The picture that a panel shows of the open scene.
    Frame {
        /// What decides it.
        look: Look,
    },
    /// The rays that each pixel takes, as a picture.
    Heat {
        /// What decides it.
        look: Look,
    },
    /// What a pixel of the picture drawn last is.
    Pixel {
        /// Column and row.
        at: [u32; 2],
    },
    /// Rust source of the open scene.
    Source {
        /// The number it is for.
        number: String,
    },
}
