//! The scanray core on a desktop: pictures, panels, the reference they are judged by.

pub mod animation;
pub mod bake;
pub mod bench;
pub mod canvas;
pub mod cli;
pub mod compare;
pub mod dither;
pub mod images;
pub mod memory;
pub mod model;
pub mod obj;
pub mod panel;
pub mod picture;
pub mod png;
pub mod race;
pub mod raster;
pub mod reference;
pub mod refine;
pub mod rounded;
pub mod scene_file;
pub mod scenes;
pub mod shot;
pub mod show;
pub mod suggest;
pub mod terminal;
pub mod turn;
