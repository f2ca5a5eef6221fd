//! Tracing: what a ray meets, how the surface is lit, where the light goes on.

mod departure;
mod detail;
mod direct;
mod lane;
mod observer;
mod packet;
mod pending;
mod shade;
mod shadow;
mod step;
mod tracer;
mod tree;
mod veiled;
mod vicinity;
mod visibility;

pub(crate) use direct::direct_light;
pub use lane::LANES;
pub use observer::{Observer, RayCounts, RayKind};
pub use packet::Packet;
pub use pending::Pending;
pub use step::Step;
pub use tracer::Tracer;
pub use vicinity::Vicinities;
pub use visibility::Candidates;
