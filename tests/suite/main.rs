//! What the core promises, a file each.
//!
//! One program, so that the tracer is compiled for it once and not for each file.

#[macro_use]
mod kit;

mod adaptive;
mod ascii;
mod bounds;
mod camera;
mod checks;
mod color_chart;
mod cones;
mod culling;
mod display;
mod dither;
mod environment;
mod extension;
mod faint;
mod faults;
mod functions;
mod gallery;
mod glass;
mod hierarchies;
mod invariants;
mod isosurfaces;
mod memory;
mod meshes;
mod models;
mod numbers;
mod output;
mod polygons;
mod progressive;
mod raster;
mod raster_random;
mod raster_sides;
mod reliefs;
mod sampling;
mod shapes;
mod smooth;
mod soak;
mod spans;
mod spectrum;
mod support;
mod textures;
mod turn;
mod units;
mod vectors;
mod volumes;
mod walks;
mod workspace;
