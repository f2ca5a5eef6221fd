//! Scenes of the gallery as files, their images, meshes and voxels beside them.

use host_sim::scene_file::{describe, write};
use host_sim::scenes::Entry;
use std::path::Path;

/// Writes the files of a scene into a folder, under a stem; answers the text of its file.
pub fn export(entry: &Entry, folder: &Path, stem: &str) -> String {
    let mut description =
        describe(entry.double).unwrap_or_else(|unsayable| panic!("{}: {unsayable}", entry.name()));
    for file in description.name_files(stem) {
        file.write(&folder.join(file.name())).unwrap();
    }
    write(&description).expect("what was described can be written")
}

/// Leaves out of a text where images and voxels are in memory.
pub fn anywhere(text: &str) -> String {
    let mut pieces = text.split(" 0x");
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |text, piece| text + piece.trim_start_matches(|c: char| c.is_ascii_hexdigit()))
}
