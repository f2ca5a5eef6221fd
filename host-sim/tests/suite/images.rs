//! The images in the core are those that are computed here.

use std::fs;
use std::path::Path;

#[test]
fn the_images_of_the_gallery_are_as_computed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/gallery/images");
    let images = host_sim::images::all();
    for (name, bytes) in &images {
        let kept = fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(kept == *bytes, "{name}: write it again with `cargo run -p host-sim --example images`");
    }
    let files = fs::read_dir(&folder).expect("the folder of the images").count();
    assert_eq!(files, images.len(), "a file that nobody computes");
}
