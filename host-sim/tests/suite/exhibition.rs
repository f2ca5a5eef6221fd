//! The gallery as pages: what they show is there, and is what the core draws.

use crate::desk::{Desk, assert_refused, read, stdout};
use host_sim::panel::Panel;
use host_sim::scenes;
use host_sim::shot::{Number, Shot};
use std::path::Path;

/// Answers what stands between quotes after a name, wherever it stands in a page.
fn named<'p>(page: &'p str, name: &str) -> Vec<&'p str> {
    page.split(&format!(" {name}=\"")).skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

fn page(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn every_picture_and_page_that_a_page_leads_to_is_there() {
    let desk = Desk::new("gallery");
    let output = desk.run("gallery glass three-spheres -o public --size 24x18");
    assert!(output.status.success(), "{output:?}");
    assert!(stdout(&output).contains("index.html"), "{}", stdout(&output));
    let public = desk.0.join("public");
    for folder in [public.clone(), public.join("glass"), public.join("three-spheres")] {
        let page = page(&folder.join("index.html"));
        let (pictures, links) = (named(&page, "src"), named(&page, "href"));
        assert!(pictures.len() >= 2 && links.len() >= 2, "{page}");
        for file in pictures.into_iter().chain(links) {
            assert!(folder.join(file).is_file(), "{} leads to {file}", folder.display());
        }
        // Who cannot see a picture is told of it.
        assert_eq!(page.matches("<img").count(), named(&page, "alt").len(), "{page}");
    }
}

#[test]
fn every_number_and_panel_shows_what_is_drawn_in_it() {
    let desk = Desk::new("gallery-pictures");
    assert!(desk.run("gallery glass -o public --size 24x18").status.success());
    let glass = scenes::find("glass").expect("a scene of the gallery");
    for number in Number::ALL {
        for panel in Panel::ALL {
            let shot = Shot { number, panel, size: [24, 18], ..Shot::new(glass) };
            let drawn = shot.take(|_| ()).expect("the gallery can be drawn").picture;
            let file = format!("public/glass/{}-{}.png", number.name(), panel.name());
            assert_eq!(read(&desk.0.join(&file)), (drawn.pixels, drawn.size), "{file}");
        }
    }
}

#[test]
fn words_of_a_scene_are_no_page_and_no_address_of_their_own() {
    let desk = Desk::new("gallery-words");
    let text = "Scene(about: \"<b>bold</b> & more\", size: (8, 6), camera: (eye: (0, 0, 5), center: (0, 0, 0), \
        projection: Perspective(fovy: 40)), materials: {\"red\": (color: (1, 0, 0))}, \
        objects: [(shape: Sphere(center: (0, 0, 0), radius: 1), material: \"red\")])";
    std::fs::write(desk.0.join("50%#1?.ron"), text).unwrap();
    let output = desk.run("gallery 50%#1?.ron -o public");
    assert!(output.status.success(), "{output:?}");
    let entrance = page(&desk.0.join("public/index.html"));
    assert_eq!(named(&entrance, "href")[1..], ["50%25%231%3F/index.html"], "{entrance}");
    for file in ["public/index.html", "public/50%#1?/index.html"] {
        let page = page(&desk.0.join(file));
        assert!(page.contains("&lt;b&gt;bold&lt;/b&gt; &amp; more") && !page.contains("<b>"), "{page}");
    }
}

#[test]
fn a_gallery_without_a_place_or_of_an_unknown_scene_is_refused() {
    let desk = Desk::new("gallery-refused");
    assert_refused(&desk, "gallery", &["--output"]);
    assert_refused(&desk, "gallery glas -o public", &["glass"]);
}
