//! What is made on a desktop so that a device only has to walk it.

mod bounds;
mod bvh;
mod cube;
mod indexed;

pub use bounds::Bounds;
pub use bvh::Bvh;
pub use cube::Cube;
pub use indexed::{Indexed, Packed};
