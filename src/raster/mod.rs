//! The other approach: a z-buffer, one row of depths at a time (row Z1).
//!
//! A ray tracer asks for each pixel which object it sees; a z-buffer asks for each object which pixels
//! it covers, and keeps for each pixel the nearest that came along (E. Catmull 1974). Nothing here
//! meets a ray with a shape. With a row at a time, as scan-line renderers have it (G. Watkins 1970),
//! the whole buffer is a row of depths and the names of what lies there:
//!
//! ```text
//! row -> its plane through the eye
//!   -> each object: cut by the plane -> clipped by the window -> projected: a span of columns
//!     -> each column: the depth is stepped to, tested and kept if it is nearer
//!   -> each pixel: the hit of whatever was kept -> shade -> linear light -> panel
//! ```
//!
//! Stepping is possible because 1/z of anything flat grows evenly along a row, which z does not
//! (J. Blinn 1992, "Hyperbolic Interpolation"): a face costs an addition and a comparison a pixel, where
//! a ray takes some fifty operations to meet it. A ball's 1/z takes one square root of a product of two
//! evenly growing numbers, see `ball.rs`.
//!
//! What is gained is speed where many objects lie along a ray; what is lost is all that needs another
//! ray: there are no shadows and no mirrors. Lit places are lit by the tracer's own code.

mod ball;
mod clearance;
mod cuboid;
mod depths;
mod figure;
mod level;
mod renderer;
mod shading;
mod slice;
mod span;
mod triangle;
mod workspace;

pub use renderer::RasterRenderer;
pub use workspace::RasterWorkspace;
