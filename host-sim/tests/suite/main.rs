//! What the desktop promises, a file each, and the core before its reference.
//!
//! One program, so that the tracer is compiled for it once and not for each file.

mod bake;
mod bench;
mod classics;
mod cli;
mod cli_compare;
mod cli_pictures;
mod cost;
mod desk;
mod dither;
mod explain;
mod figures;
mod growth;
mod hierarchies;
mod hierarchies_scenes;
mod hostile;
mod hostile_models;
mod images;
mod lessons;
mod meshes;
mod model_files;
mod models;
mod nff;
mod nff_mistakes;
mod nff_random;
mod nff_rivals;
mod nff_text;
mod pictures;
mod race;
mod raster;
mod reference_door;
mod reference_known;
mod reference_random;
mod reference_recipe;
mod scene_file_bodies;
mod scene_file_images;
mod scene_file_manual;
mod scene_file_mistakes;
mod scene_file_random;
mod scene_files;
mod scene_folder;
mod threads;
mod tight;
mod walks;
mod window;
