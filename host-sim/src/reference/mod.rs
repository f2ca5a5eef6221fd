//! The reference: a second ray tracer, in `f64`, by other formulas.
//!
//! It shares the scene description with the core and nothing else. [`Description`] and [`Output`]
//! are its only doors: they copy plain data, and no other file here may name the core. Where the
//! core has one formula, the reference has another: the quadratic with both of its roots, a
//! triangle by its plane and areas, a box by six planes, a polygon by sums of angles, a field by eight weights, bounces by recursion, rays by inverted
//! camera matrices, every object asked every time, `powf` and the exact transfer curve.
//!
//! Besides light it answers a [`Trail`] for each pixel: all that the ray tree met. Where the trails
//! of two neighbours differ there is a silhouette, and a rounding error may show either side. And of a
//! single pixel it answers an [`Account`]: every ray of its tree with what it brings.

mod account;
mod camera;
mod cone;
mod description;
mod displaced;
mod display;
mod door;
mod field;
mod glass;
mod groups;
mod light;
mod matrix;
mod mesh;
mod outline;
mod picture;
mod raster;
mod reflection;
mod roots;
mod shape;
mod smooth;
mod texture;
mod trail;
mod vector;
mod volume;

pub use account::{Account, Lit, Shine, Surface, Visit};
pub use description::{Description, Output, Unknown};
pub use display::{shown, wanted};
pub use picture::{Picture, account, trace};
pub use trail::{Stop, Trail};
pub use vector::Vector;
