//! Rendering: rows of rays into a scanline, scanlines into a display.

mod adaptive;
mod alike;
mod band;
mod block;
mod edges;
mod error;
mod marks;
mod pattern;
mod picture;
mod progressive;
mod quality;
mod renderer;
mod samples;
mod settings;
mod spans;
mod workspace;

pub use error::{RenderError, RowError};
pub use progressive::Progress;
pub use quality::{Adaptive, AtEdges, Exact, Jittered, Pointwise, Quality, Uniform};
pub use renderer::Renderer;
pub use settings::Settings;
pub use spans::Spans;
pub use workspace::Workspace;
