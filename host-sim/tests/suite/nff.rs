//! The Neutral File Format as its text has it: what each entity becomes, in every number.

use crate::desk::{Desk, stderr, stdout};
use crate::nff_text::{PUBLISHED, path};
use host_sim::nff::note::What;
use host_sim::nff::{Read, describe::DEPTH, read};
use host_sim::panel::Panel;
use host_sim::picture::trace;
use host_sim::scene_file::shape::{FillRule, Shape, Vertex};
use host_sim::scene_file::value::{Color, Point};
use host_sim::scene_file::{light::Light, parse, sky::Sky};
use host_sim::scenes;
use scanray::{Fixed, Vec3};
use std::path::Path;

const HEAD: &str =
    "v from 0 0 9 at 0 0 0 up 0 0.5 0 angle 45 hither 1 resolution 64 48\nf 1 0.5 0.2 0.8 0 9 0 1\n";

/// Reads entities after a viewpoint and a fill.
fn read_after_head(entities: &str) -> Read {
    read(&(HEAD.to_owned() + entities)).unwrap_or_else(|mistake| panic!("{mistake:?}"))
}

/// Answers the shapes that entities become, and the kinds of notes and their lines.
fn shapes(entities: &str) -> (Vec<Shape>, Vec<(What, Vec<usize>)>) {
    let Read { description, notes, .. } = read_after_head(entities);
    let notes = notes.into_iter().map(|note| (note.what, note.lines)).collect();
    (description.objects.into_iter().map(|(shape, _)| shape).collect(), notes)
}

fn patch(corners: &[Point], normal: &str) -> String {
    let corner = |[x, y, z]: &Point| format!("{x} {y} {z} {normal}\n");
    format!("pp {}\n{}", corners.len(), corners.iter().map(corner).collect::<String>())
}

#[test]
fn every_published_file_can_be_drawn_in_every_number() {
    for name in PUBLISHED {
        let entry = scenes::read(&path(name)).unwrap_or_else(|failure| panic!("{failure}"));
        assert_eq!((entry.name(), entry.double.size), (name, [512, 512]));
        for check in [entry.float.scene.check(), entry.fixed.scene.check(), entry.double.scene.check()] {
            assert_eq!(check, Ok(()), "{name}");
        }
        let largest = entry.double.scene.largest();
        assert!((128.0..=512.0).contains(&largest), "{name} does not use the range: {largest}");
        let notes = entry.file.expect("it is of a file").notes();
        assert_eq!(notes.len(), if name == "teapot1" { 3 } else { 0 }, "{name}: {notes:?}");
    }
}

#[test]
fn the_pictures_of_published_files_in_fixed_point_for_rgb565_are_what_has_been_looked_at() {
    for name in ["balls2", "teapot1", "tree1"] {
        let entry = scenes::read(&path(name)).unwrap_or_else(|failure| panic!("{failure}"));
        let view = entry.fixed;
        let film = trace(view, view.settings, view.size, |_| ()).expect("it can be drawn");
        let drawn = film.on_panel(Panel::Rgb565, view.settings.transfer, view.settings.dither).concat();
        let picture = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../pictures/{name}.png"));
        let looked_at = image::open(&picture).expect("it is there").to_rgb8();
        let apart = looked_at.iter().zip(&drawn).filter(|(a, b)| a != b).count();
        let hint = format!("cargo sim render scenes/nff/{name}.nff --number fixed -o pictures/{name}.png");
        assert_eq!((apart, looked_at.len()), (0, drawn.len()), "{name}: look at it, then `{hint}`");
    }
}

#[test]
fn a_picture_does_not_know_the_units_of_its_file() {
    let text = std::fs::read_to_string(path("tree1")).expect("it is there");
    let (scene, _) = host_sim::nff::parse(&text).expect("it has no mistake");
    let desk = Desk::new("units");
    let mut pictures = vec![];
    for factor in [1.0, 1_048_576.0, 1.0 / 1024.0] {
        let file = desk.0.join("x.nff");
        std::fs::write(&file, crate::nff_text::write(&scene.scaled(factor))).expect("it can be written");
        let view = scenes::read(&file).unwrap_or_else(|failure| panic!("{failure}")).fixed;
        pictures.push(trace::<Fixed>(view, view.settings, [64, 64], |_| ()).expect("it can be drawn").light);
    }
    assert!(pictures[0] == pictures[1] && pictures[0] == pictures[2]);
}

#[test]
fn the_angle_is_that_between_the_middles_of_the_first_and_the_last_row() {
    let camera = read_after_head("").description.camera;
    assert_eq!((camera.up, camera.near, camera.far), (None, Some(1.0), None));
    let frame = camera.in_number::<f64>().frame(64, 48).expect("it is a camera");
    let slopes = [0, 47].map(|row| {
        let ray = frame.row(row, 0).next().expect("a row never ends").ray.direction;
        (ray.y / -ray.z).atan().to_degrees()
    });
    assert!((slopes[0] - 22.5).abs() < 1e-9 && (slopes[1] + 22.5).abs() < 1e-9, "{slopes:?}");
}

#[test]
fn lights_without_a_colour_share_their_intensity_and_others_have_their_own() {
    let lights = "l 1 2 3\nl 4 5 6 0.1 0.2 0.3\nl 7 8 9\nl 1 1 1\n";
    let description = read_after_head(lights).description;
    let light = |position, color| Light::Point { position, color: Color(color) };
    let half = [0.5; 3];
    let [first, last] = [light([1.0, 2.0, 3.0], half), light([1.0; 3], half)];
    let wanted = [first, light([4.0, 5.0, 6.0], [0.1, 0.2, 0.3]), light([7.0, 8.0, 9.0], half), last];
    assert_eq!(description.lights, wanted);
    assert_eq!(description.sky, Some(Sky::Solid { color: Color([0.0; 3]) }));
}

#[test]
fn a_fill_is_diffuse_light_a_highlight_a_mirror_and_glass() {
    let fills = "s 0 0 0 1\nf 1 0.5 0.25 0.5 0.25 3.6 0 0\ns 2 0 0 1\nf 1 1 1 0.1 0.1 101.148 0.9 1.5\ns 4 0 0 1\n\
                 f 1 0.5 0.2 0.8 0 9 0 1\ns 6 0 0 1\n";
    let Read { description, notes, .. } = read_after_head(fills);
    assert_eq!(notes, []);
    let used: Vec<u16> = description.objects.iter().map(|(_, material)| *material).collect();
    assert_eq!(used, [0, 1, 2, 0], "equal fills are one material");
    let [matte, mirror, glass] = &description.materials[..] else { panic!("three materials") };
    assert_eq!(
        (matte.1.color, matte.1.specular, matte.1.mirror),
        (Some(Color([0.8, 0.4, 0.2 * 0.8])), None, None)
    );
    let (color, specular) = (Some(Color([0.5, 0.25, 0.125])), Some(Color([0.25; 3])));
    assert_eq!((mirror.1.color, mirror.1.specular), (color, specular));
    assert_eq!((mirror.1.shininess, mirror.1.mirror, mirror.1.glass), (Some(4), Some(0.25), None));
    let inside = glass.1.glass.expect("light comes through");
    assert_eq!((inside.transmission, inside.index, inside.fresnel), (0.9, 1.5, None));
    assert_eq!(description.settings.depth, Some(DEPTH));
}

#[test]
fn what_is_drawn_otherwise_is_said_with_its_line() {
    let (round, notes) = shapes("s 0 0 0 -2\ns 0 0 0 0\nc 0 0 0 -1 0 1 0 -0.5\nc 0 0 0 1 0 0 0 2\n");
    let cone = Shape::Cone {
        base: [0.0; 3],
        base_radius: 1.0,
        apex: [0.0, 1.0, 0.0],
        apex_radius: 0.5,
        capped: Some(false),
    };
    assert_eq!(round, [Shape::Sphere { center: [0.0; 3], radius: 2.0 }, cone]);
    assert_eq!(notes, [(What::Nothing, vec![4, 6]), (What::Inside, vec![3, 5])]);
    let (none, notes) = shapes("p 3 0 0 0 1 1 1 2 2 2\npp 3 0 0 0 0 0 1\n1 1 1 0 0 1 5 5 5 0 0 1\n");
    assert_eq!((none, notes), (vec![], vec![(What::Sliver, vec![3, 4])]));
    let glass = "f 1 1 1 0.1 0.5 9 0.9 1.5\np 3 0 0 0 1 0 0 0 1 0\ns 0 0 0 1\n";
    let Read { description, notes, .. } = read_after_head(glass);
    let lines: Vec<_> = notes.iter().map(|note| (note.what, &note.lines[..])).collect();
    assert_eq!(lines, [(What::Opaque, &[4][..]), (What::Bright, &[3])]);
    let [wall, ball] = &description.materials[..] else { panic!("two materials") };
    assert!(wall.1.glass.is_none() && ball.1.glass.is_some());
    assert!(wall.1.mirror == Some(0.5) && ball.1.mirror.is_some_and(|m| (m - 0.1).abs() < 1e-12));
}

#[test]
fn a_polygon_is_a_triangle_or_an_outline_of_any_form_and_a_bent_one_is_cut() {
    let (flat, notes) = shapes("p 3 0 0 0 1 0 0 0 1 0\np 4 0 0 2 4 0 2 1 1 2 0 4 2\n");
    assert_eq!(notes, []);
    assert_eq!(flat[0], Shape::Triangle { a: [0.0; 3], b: [1.0, 0.0, 0.0], c: [0.0, 1.0, 0.0] });
    let Shape::Polygon { vertices, normal, rule: FillRule::OddEven } = &flat[1] else { panic!("{flat:?}") };
    assert_eq!((vertices.len(), normal), (4, &[0.0, 0.0, 1.0]));
    // A bow tie runs around as much area one way as the other.
    let (tie, notes) = shapes("p 4 0 0 0 2 2 0 2 0 0 0 2 0\n");
    assert!(matches!(tie[..], [Shape::Polygon { .. }]) && notes.is_empty(), "{tie:?} {notes:?}");
    let (bent, notes) = shapes("p 4 0 0 0 1 0 0 1 1 0.5 0 1 0\n");
    assert!(matches!(bent[..], [Shape::Triangle { .. }, Shape::Triangle { .. }]), "{bent:?}");
    assert_eq!(notes, [(What::Bent, vec![3])]);
}

fn area([a, b, c]: [Point; 3]) -> f64 {
    let [a, b, c] = [a, b, c].map(Vec3::from_array);
    0.5 * (b - a).cross(c - a).length()
}

#[test]
fn a_concave_patch_is_cut_into_triangles_that_cover_it_once_and_face_as_it_does() {
    // A comb of four teeth, and the same as seen in the other planes.
    let mut comb: Vec<Point> = vec![[0.0, -1.0, 3.0], [8.0, -1.0, 3.0]];
    comb.extend((0..=16).rev().map(|i| [0.5 * f64::from(i), f64::from(1 + 3 * (i & 2)), 3.0]));
    for turn in 0..3 {
        let turned = |[x, y, z]: Point| [[x, y, z], [z, x, y], [y, z, x]][turn];
        let normal = turned([0.0, 0.0, 1.0]).map(|c| c.to_string()).join(" ");
        let corners: Vec<Point> = comb.iter().copied().map(turned).collect();
        let (triangles, notes) = shapes(&patch(&corners, &normal));
        assert_eq!((triangles.len() <= comb.len() - 2, notes), (true, vec![]));
        let mut covered = 0.0;
        for triangle in &triangles {
            let Shape::SmoothTriangle { a, b, c } = triangle else { panic!("{triangle:?}") };
            covered += area([a.point, b.point, c.point]);
        }
        // By Gauss's formula, of the outline.
        let pairs = comb.iter().zip(comb.iter().cycle().skip(1));
        let whole: f64 = pairs.map(|([x, y, _], [u, v, _])| 0.5 * (x * v - u * y)).sum();
        assert!((covered - whole.abs()).abs() < 1e-9, "{covered} of {whole}");
    }
}

#[test]
fn normals_are_made_to_point_outward_and_to_have_unit_length() {
    let text = "pp 3 0 0 0 0 0 5\n1 0 0 3 0 -4\n0 1 0 1 0 0\n";
    let (patch, notes) = shapes(text);
    let [Shape::SmoothTriangle { a, b, c }] = &patch[..] else { panic!("{patch:?}") };
    let normals = [a, b, c].map(|Vertex { normal, .. }| normal.map(|c| (c * 1e9).round() / 1e9));
    assert_eq!(normals, [[0.0, 0.0, 1.0], [-0.6, 0.0, 0.8], [0.0, 0.0, 1.0]]);
    assert_eq!(notes, [(What::Turned, vec![3]), (What::Level, vec![3])]);
}

#[test]
fn a_file_is_taken_wherever_a_scene_is_and_its_notes_go_to_stderr() {
    let desk = Desk::new("nff");
    let teapot = path("teapot1");
    let teapot = teapot.display();
    let listed = desk.run(&format!("list {teapot}"));
    assert!(stdout(&listed).starts_with("teapot1  512x512  "), "{listed:?}");
    assert!(stderr(&listed).contains("teapot1.nff: lines 163, 167, 171, 175: its corners lie on a line"));
    assert!(desk.run(&format!("export {teapot} -o pot.ron")).status.success());
    let exported = std::fs::read_to_string(desk.0.join("pot.ron")).expect("it was written");
    let (again, _) = parse(&exported).expect("it can be read");
    let original = read(&std::fs::read_to_string(path("teapot1")).expect("it is there")).expect("no mistake");
    assert_eq!(format!("{again:?}"), format!("{:?}", original.description));
    for number in ["f32", "fixed", "exact"] {
        let compared = desk.run(&format!("compare {teapot} --size 24x24 --number {number} --json"));
        assert!(stdout(&compared).contains("\"scene\": \"teapot1\""), "{compared:?}");
    }
    assert!(stderr(&desk.run("show none.nff")).contains("cannot read none.nff"));
}
