//! The scanray core on a desktop: pictures, panels, the reference they are judged by.
//!
//! The feature `desktop`, on by default, adds what needs a terminal, a window, a network or other programs.

#[cfg(feature = "desktop")]
pub mod animation;
pub mod bake;
#[cfg(feature = "desktop")]
pub mod bench;
#[cfg(feature = "desktop")]
pub mod boards;
pub mod canvas;
#[cfg(feature = "desktop")]
pub mod cli;
pub mod compare;
pub mod cost;
pub mod dither;
#[cfg(feature = "desktop")]
pub mod exhibition;
pub mod explain;
pub mod files;
pub mod growth;
mod image_error;
pub mod images;
#[cfg(feature = "desktop")]
pub mod lessons;
pub mod memory;
pub mod meshes;
pub mod model;
pub mod nff;
pub mod obj;
pub mod orbit;
pub mod panel;
pub mod picture;
pub mod png;
#[cfg(feature = "desktop")]
pub mod proof;
#[cfg(feature = "desktop")]
pub mod race;
pub mod raster;
pub mod reference;
pub mod refine;
pub mod rounded;
pub mod scene_file;
pub mod scenes;
#[cfg(feature = "desktop")]
pub mod serve;
pub mod shot;
#[cfg(feature = "desktop")]
pub mod show;
pub mod suggest;
pub mod terminal;
pub mod turn;
pub mod walks;
pub mod word;
