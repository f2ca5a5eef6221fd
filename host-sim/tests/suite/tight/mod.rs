//! How tight the geometry is: closed meshes let no ray through, no surface shades itself, distances are right, and
//! light is neither lost nor made.
//!
//! The plain tests take samples; `cargo test --release -p host-sim --test suite tight -- --ignored --nocapture` takes
//! as many rays as the figures that are published of other tracers, and prints its own.

mod closed;
mod distances;
mod furnace;
mod leaving;
