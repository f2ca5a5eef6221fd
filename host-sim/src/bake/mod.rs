//! What is made on a desktop so that a device only has to walk it.

mod accel;
mod bounds;
mod boxes;
mod bvh;
mod cube;
mod grid;
mod indexed;
mod kd;
mod lists;
mod octree;

pub use accel::{Accel, Built};
pub use bounds::Bounds;
pub use bvh::Bvh;
pub use cube::Cube;
pub use grid::Grid;
pub use indexed::{Indexed, Packed};
pub use kd::Kd;
pub use octree::Octree;
