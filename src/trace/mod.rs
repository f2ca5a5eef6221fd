//! Tracing: what a ray meets, how the surface is lit, where the light goes on.

mod departure;
mod detail;
mod lane;
mod observer;
mod shade;
mod shadow;
mod tracer;
mod vicinity;
mod visibility;

pub use lane::LANES;
pub use observer::{Observer, RayCounts, RayKind};
pub use tracer::{Packet, Tracer};
pub use vicinity::Vicinities;
pub use visibility::Candidates;
