//! Rendering: rows of rays into a scanline, scanlines into a display.

mod adaptive;
mod error;
mod marks;
mod picture;
mod renderer;
mod settings;
mod spans;
mod workspace;

pub use error::{RenderError, RowError};
pub use renderer::Renderer;
pub use settings::{Adaptive, Exact, Quality, Settings};
pub use spans::Spans;
pub use workspace::Workspace;
