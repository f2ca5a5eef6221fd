//! The picture of the discrete walks is the one that has been looked at.

use std::path::Path;

#[test]
fn the_picture_of_the_walks_is_what_has_been_looked_at() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../pictures/walks.png");
    let kept = image::open(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display())).to_rgb8();
    let drawn = host_sim::walks::sheet();
    assert_eq!([kept.width(), kept.height()], drawn.size);
    let same = kept.pixels().zip(&drawn.pixels).all(|(kept, drawn)| kept.0 == *drawn);
    assert!(same, "look at it, then `cargo sim walks -o pictures/walks.png`");
}
