//! Rendering: rows of rays into a scanline, scanlines into a display.

mod error;
mod picture;
mod renderer;
mod settings;
mod spans;
mod workspace;

pub use error::{RenderError, RowError};
pub use renderer::Renderer;
pub use settings::Settings;
pub use spans::Spans;
pub use workspace::Workspace;
