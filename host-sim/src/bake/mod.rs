//! What is made on a desktop so that a device only has to walk it.
//!
//! Hierarchies over things in boxes ([`Bvh`]), what of a mesh is told in few bits ([`steps`], [`octahedron`]),
//! and whole scenes as Rust source ([`source`], [`mod@file`]).

mod accel;
mod bill;
mod bounds;
mod boxes;
mod bvh;
mod cube;
pub mod file;
mod grid;
mod indexed;
mod kd;
mod lists;
pub mod meshes;
pub mod objects;
pub mod octahedron;
mod octree;
pub mod source;
pub mod steps;
mod tree;

pub use accel::{Accel, Built};
pub use bill::Bill;
pub use bounds::Bounds;
pub use bvh::Bvh;
pub use cube::Cube;
pub use grid::Grid;
pub use indexed::{Indexed, Packed};
pub use kd::Kd;
pub use octree::Octree;
pub use tree::Tree;
