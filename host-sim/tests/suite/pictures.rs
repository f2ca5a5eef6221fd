//! The pictures of the README and of the documentation are what the core draws, to the last bit.

use host_sim::panel::Panel;
use host_sim::picture::trace;
use scanray::gallery::{self, Gallery, View};
use scanray::{AtEdges, Dither, Exact, Fixed, Quality, Uniform};
use std::path::Path;

#[test]
fn the_gallery_in_fixed_point_for_rgb565_is_what_has_been_looked_at() {
    for view in Fixed::views() {
        assert_looked_at(view, Exact, view.name, "");
    }
}

#[test]
fn several_rays_a_pixel_on_edges_are_what_has_been_looked_at() {
    let view = &gallery::fixed::THREE_SPHERES;
    assert_looked_at(view, AtEdges(Uniform(3)), "three-spheres-samples", "--samples 3 --adaptive-samples ");
}

/// It is text, so that the page of the documentation needs no other file; unrounded by a pattern it is short.
#[test]
fn the_picture_of_the_documentation_is_what_has_been_looked_at() {
    use base64::prelude::{BASE64_STANDARD, Engine};
    let view = &gallery::fixed::THREE_SPHERES;
    let film = trace(view, view.settings, view.size, |_| ()).expect("the gallery can be drawn");
    let drawn = film.on_panel(Panel::Rgb565, view.settings.transfer, Dither::None).concat();
    let text = include_str!("../../../pictures/three-spheres.base64");
    let bytes = BASE64_STANDARD.decode(text).expect("the picture is base64");
    let shown = image::load_from_memory(&bytes).expect("the picture is PNG").to_rgb8();
    assert!(
        shown.into_raw() == drawn,
        "it is that of `cargo sim render three-spheres --number fixed --dither none`"
    );
}

/// Compares a picture for Rgb565 with the file that was looked at.
fn assert_looked_at(view: &View<Fixed>, quality: impl Quality + Sync, name: &str, options: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../pictures");
    let settings = view.settings.with_quality(quality);
    let film = trace(view, settings, view.size, |_| ()).expect("the gallery can be drawn");
    let drawn = film.on_panel(Panel::Rgb565, view.settings.transfer, view.settings.dither).concat();
    let file = folder.join(format!("{name}.png"));
    let looked_at = image::open(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let apart = looked_at.to_rgb8().iter().zip(&drawn).filter(|(a, b)| a != b).count();
    assert_eq!(
        (apart, looked_at.width(), looked_at.height()),
        (0, view.size[0], view.size[1]),
        "{name}: look at it, then `cargo sim render {} --number fixed {options}-o pictures/{name}.png`",
        view.name
    );
}
