//! The pictures of the README are what the core draws, to the last bit.

use host_sim::panel::Panel;
use host_sim::picture::trace;
use scanray::Fixed;
use scanray::gallery::Gallery;
use std::path::Path;

#[test]
fn the_gallery_in_fixed_point_for_rgb565_is_what_has_been_looked_at() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../pictures");
    for view in Fixed::views() {
        let film = trace(view, view.settings, view.size, |_| ()).expect("the gallery can be drawn");
        let drawn = film.on_panel(Panel::Rgb565, view.settings.transfer, view.settings.dither).concat();
        let file = folder.join(format!("{}.png", view.name));
        let looked_at = image::open(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let apart = looked_at.to_rgb8().iter().zip(&drawn).filter(|(a, b)| a != b).count();
        assert_eq!(
            (apart, looked_at.width(), looked_at.height()),
            (0, view.size[0], view.size[1]),
            "{0}: look at it, then `cargo sim render {0} --number fixed -o pictures/{0}.png`",
            view.name
        );
    }
}
