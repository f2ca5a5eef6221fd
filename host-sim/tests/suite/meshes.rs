//! The meshes in the core are those that are computed here.

use std::fs;
use std::path::Path;

#[test]
fn the_meshes_of_the_gallery_are_as_computed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/gallery/meshes");
    let meshes = host_sim::meshes::all();
    for (name, bytes) in &meshes {
        let kept = fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(kept == *bytes, "{name}: write it again with `cargo run -p host-sim --example meshes`");
    }
    let files = fs::read_dir(&folder).expect("the folder of the meshes").count();
    assert_eq!(files, meshes.len(), "a file that nobody computes");
}
