//! Scene files: scenes as RON text, for those who would rather not write Rust.
//!
//! `docs/scene-format.md` is the manual. The text is read in two steps: its [outline](read::parse), whose
//! parts know their places, and each part by itself; so every mistake is shown with its line, those too that
//! the core finds when it draws.
//!
//! - [`value`], [`shape`], [`texture`], [`material`], [`light`], [`sky`], [`camera`], [`settings`]: the words
//!   of the format, each with its way to the core and back. A new word is added there and in the manual.
//! - [`image`], [`bump`]: images in these words; [`png_file`]: their texels.
//! - [`mesh`]: meshes, [`mesh_file`]: their triangles, `placement`: where they stand, [`ready`]: what is drawn
//!   of them. [`mod@grid`], [`volume`]: fields of voxels; [`voxel_file`]: their values.
//! - [`mod@beside`]: files that lie beside a scene's, [`opening`]: how they are opened; `album`: all that a
//!   description names.
//! - [`description`]: a whole scene in these words; [`from_core`]: of a view; [`names`]: of its materials.
//! - [`mod@read`] and [`mod@write`]: text to description and back; [`place`], [`mistake`]: what is wrong, and where.
//! - [`mod@file`]: a file as a scene that commands take.

mod album;
pub mod beside;
pub mod bump;
pub mod camera;
pub mod description;
pub mod file;
pub mod from_core;
pub mod glass;
pub mod grid;
pub mod image;
pub mod light;
pub mod material;
pub mod mesh;
pub mod mesh_file;
pub mod mistake;
pub mod names;
pub mod opening;
mod outline;
pub mod place;
mod placement;
pub mod png_file;
pub mod read;
pub mod ready;
pub mod settings;
pub mod shape;
pub mod sky;
pub mod texture;
pub mod value;
pub mod volume;
pub mod voxel_file;
pub mod write;

pub use description::Description;
pub use file::{Failure, SceneFile};
pub use from_core::{Unsayable, describe};
pub use mistake::{Complaint, Mistake, Reason};
pub use read::parse;
pub use write::{write, write_object};
