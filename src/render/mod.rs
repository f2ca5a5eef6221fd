//! Rendering: rows of rays into a scanline, scanlines into a display.

mod candidates;
mod error;
mod picture;
mod renderer;
mod settings;
mod workspace;

pub use candidates::Candidates;
pub use error::{RenderError, RowError};
pub use renderer::Renderer;
pub use settings::Settings;
pub use workspace::Workspace;
