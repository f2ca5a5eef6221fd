//! Wavefront OBJ and MTL files: what 3D programs write, as a [`Model`](crate::model::Model).
//!
//! The format is that of Wavefront's Advanced Visualizer (appendix B1 of its manual).
//! `docs/baking.md` says what of it is understood. A file goes through three steps:
//!
//! - [`mod@survey`], [`library`]: every line that says something of surfaces is checked, so that a mistake is
//!   told with its line; all others are left out.
//! - The crate `tobj` reads the lines that are left, and cuts polygons into triangles.
//! - [`mod@read`]: its lists become a model. [`wrong`]: what may be wrong.
//!
//! [`mod@write`] goes the other way, with triangles alone.

pub mod library;
pub mod read;
pub mod survey;
pub mod write;
pub mod wrong;

pub use read::{parse, plan, read, surfaces};
pub use write::write;
pub use wrong::{Mistake, Reason};

use std::path::Path;

/// Tells by its name whether a file is in this format: it ends in `.obj`, in letters of either case.
pub fn is_named(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("obj"))
}
