//! Tracing: what a ray meets, how the surface is lit, where the light goes on.

mod bounce;
mod observer;
mod shade;
mod visibility;

pub use bounce::{Bounce, Tracer};
pub use observer::{Observer, RayCounts, RayKind};
pub use visibility::{Found, nearest, occluded};
