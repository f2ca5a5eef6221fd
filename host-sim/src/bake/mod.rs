//! What is made on a desktop so that a device only has to walk it.
//!
//! Hierarchies over things in boxes ([`Bvh`]), what of a mesh is told in few bits ([`steps`], [`octahedron`]),
//! and whole scenes as Rust source ([`source`], [`mod@file`]).

mod bill;
mod bounds;
mod bvh;
mod choice;
mod cube;
pub mod file;

mod indexed;
pub mod objects;
pub mod octahedron;
pub mod source;
pub mod steps;

pub use bill::Bill;
pub use bounds::Bounds;
pub use bvh::Bvh;
pub use choice::{Choice, Ordered};
pub use cube::Cube;
pub use indexed::{Indexed, Packed};
