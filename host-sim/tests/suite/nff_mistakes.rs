//! What the author of a file in the Neutral File Format is told: what is wrong, and in which line.

use host_sim::scene_file::file::MAX_BYTES;
use host_sim::scene_file::{Complaint, SceneFile};
use std::path::Path;

/// Is a file without a mistake.
const FILE: &str = "\
# a ball before a wall
b 0.1 0.2 0.3
v
from 0 0 9
at 0 0 0
up 0 1 0
angle 45
hither 1
resolution 64 48
l 3 5 4
l -3 5 4 0.5 0.5 0.5
f 0.9 0.1 0.1 0.8 0.2 30 0 1
s 0 0 0 1
c 0 -1 0 1
  0 1 0 0.5
p 3
-4 -4 -1
4 -4 -1
0 4 -1
pp 3
-1 2 0 0 0 1
1 2 0 0 0 1
0 3 0 0 0 1
";

fn read(text: &str) -> Result<SceneFile, Box<Complaint>> {
    SceneFile::parse(Path::new("my/scene.nff"), text.as_bytes().to_vec())
}

/// Demands what is told of the file with one piece of it replaced, and the line and the words underlined.
fn assert_told(piece: &str, by: &str, title: &str, (line, underlined): (usize, &str)) {
    assert_eq!(FILE.matches(piece).count(), 1, "{piece}");
    let told = read(&FILE.replace(piece, by)).expect_err(by).to_string();
    let lines: Vec<&str> = told.lines().collect();
    assert_eq!(lines[0], title, "{told}");
    assert!(lines[1].contains(&format!("my/scene.nff:{line}:")), "not in line {line}: {told}");
    let carets = lines[4].find('^').unwrap_or_else(|| panic!("nothing is underlined: {told}"));
    assert!(lines[3][carets..].starts_with(underlined), "not {underlined}: {told}");
    assert_eq!(lines[4].matches('^').count(), underlined.chars().count(), "{told}");
}

#[test]
fn the_file_has_no_mistake() {
    let file = read(FILE).unwrap_or_else(|complaint| panic!("{complaint}"));
    assert_eq!(file.notes(), []);
}

#[test]
fn a_word_that_begins_no_entity_is_shown() {
    let title = "expected one of the entities v, b, l, f, c, s, p, pp, found `q`";
    assert_told("s 0 0 0 1", "q 0 0 0 1", title, (13, "q"));
    let title = "expected one of the entities v, b, l, f, c, s, p, pp, found `7`";
    assert_told("s 0 0 0 1", "s 0 0 0 1 7", title, (13, "7"));
}

#[test]
fn a_number_that_is_missing_or_none_is_shown_where_it_was_to_stand() {
    assert_told("s 0 0 0 1", "s 0 0 0", "expected a number, found `c`", (14, "c"));
    assert_told("s 0 0 0 1", "s 0 0 0 one", "expected a number, found `one`", (13, "one"));
    for none in ["inf", "NaN", "1e17", "-1e999", "1,5", "0x1"] {
        let by = format!("s 0 0 0 {none}");
        assert_told("s 0 0 0 1", &by, &format!("expected a number, found `{none}`"), (13, none));
    }
    let title = "expected a number, found `f`";
    assert_told("l -3 5 4 0.5 0.5 0.5", "l -3 5 4 0.5 0.5", title, (12, "f"));
}

#[test]
fn a_number_of_corners_is_a_whole_one_from_3_to_16384() {
    assert_told("p 3\n-4", "p 3.5\n-4", "expected a whole number, found `3.5`", (16, "3.5"));
    assert_told("p 3\n-4", "p -3\n-4", "expected a whole number, found `-3`", (16, "-3"));
    let title = "the number of corners is to be from 3 to 16384";
    assert_told("p 3\n-4", "p 2\n-4", title, (16, "p 2"));
    assert_told("pp 3", "pp 4294967295", title, (20, "pp 4294967295"));
    assert_told("pp 3", "pp 4294967296", "expected a whole number, found `4294967296`", (20, "4294967296"));
    assert_told("p 3\n-4", "p 4\n-4", "expected a number, found `pp`", (20, "pp"));
}

#[test]
fn a_viewpoint_has_its_words_in_order_and_its_numbers_in_range() {
    assert_told("at 0 0 0", "up 0 0 0", "expected `at`, found `up`", (5, "up"));
    assert_told("hither 1\n", "", "expected `hither`, found `resolution`", (8, "resolution"));
    let title = "the angle is to be above 0 and below 180 degrees";
    assert_told("angle 45", "angle 180", title, (3, "v"));
    let title = "a picture has 1 to 4096 pixels along each side";
    assert_told("resolution 64 48", "resolution 64 0", title, (3, "v"));
    assert_told("resolution 64 48", "resolution 4097 48", title, (3, "v"));
}

#[test]
fn what_stands_once_stands_once_and_fills_before_objects() {
    assert_told("l 3 5 4", "v", "there is an entity v already", (10, "v"));
    assert_told("l 3 5 4", "b 0 0 0", "there is an entity b already", (10, "b"));
    let title = "expected a fill, an entity f, before the first object";
    assert_told("l 3 5 4", "s 0 0 0 1", title, (10, "s"));
    let told = read("b 0 0 0\n# v\n").expect_err("no viewpoint").to_string();
    assert!(told.starts_with("there is no viewpoint: expected an entity v"), "{told}");
}

#[test]
fn a_fill_has_its_numbers_in_range() {
    let line = "f 0.9 0.1 0.1 0.8 0.2 30 0 1";
    let wrong = [
        ("f 0.9 0.1 0.1 -1 0.2 30 0 1", "Kd is to be at least 0"),
        ("f 0.9 0.1 0.1 0.8 -1 30 0 1", "Ks is to be at least 0"),
        ("f 0.9 0.1 0.1 0.8 0.2 -1 0 1", "Shine is to be at least 0"),
        ("f 0.9 0.1 0.1 0.8 0.2 30 1.1 1", "T is to be from 0 to 1"),
    ];
    for (by, title) in wrong {
        assert_told(line, by, title, (12, by));
    }
}

#[test]
fn a_cone_is_seen_from_outside_or_from_inside() {
    let title = "the radii at both ends are to have the same sign";
    assert_told("0 1 0 0.5", "0 1 0 -0.5", title, (14, "c 0 -1 0 1"));
}

#[test]
fn a_file_that_ends_too_early_shows_what_it_ends_within() {
    let told = read(FILE.trim_end().trim_end_matches("0 0 1")).expect_err("it is cut").to_string();
    assert!(told.starts_with("expected a number, but the file ends within this"), "{told}");
    assert!(told.contains("my/scene.nff:20:1"), "{told}");
}

#[test]
fn what_the_core_refuses_is_shown_in_its_line() {
    let glass = "f 0.9 0.1 0.1 0.8 0.2 30 0.5 0";
    let title = "material 0: its refractive index is not between 1/8 and 8";
    assert_told("f 0.9 0.1 0.1 0.8 0.2 30 0 1", glass, title, (12, glass));
    let sky = "b 0.1 0.2 -0.3";
    let told = read(&FILE.replace("b 0.1 0.2 0.3", sky)).expect_err(sky).to_string();
    assert!(told.starts_with("sky: ") && told.contains("scene.nff:2:1"), "{told}");
    let told = read(&FILE.replace("at 0 0 0", "at 0 0 9")).expect_err("no direction").to_string();
    assert!(told.starts_with("camera: eye and center coincide") && told.contains("scene.nff:3:1"), "{told}");
}

#[test]
fn more_than_65535_shapes_are_refused_in_the_line_of_the_first_too_many() {
    let line = FILE.lines().count() + 65_532;
    let told = read(&(FILE.to_owned() + &"s 0 0 0 1\n".repeat(65_533))).expect_err("too many").to_string();
    assert!(told.starts_with("there are more than 65535 of them"), "{told}");
    assert!(told.contains(&format!("scene.nff:{line}:1")), "{told}");
}

#[test]
fn the_mistake_is_told_as_the_manual_says() {
    let manual = include_str!("../../../docs/nff.md");
    let block = |kind: &str| {
        let (_, rest) = manual.split_once(&format!("\n```{kind}\n")).expect("the manual has an example");
        rest.split("\n```").next().unwrap_or_default().to_owned()
    };
    let wrong = block("nff wrong").into_bytes();
    let told = SceneFile::parse(Path::new("ball.nff"), wrong).expect_err("it is wrong").to_string();
    assert_eq!(told, block("text"));
}

#[test]
fn files_too_large_are_refused_and_letters_of_any_kind_are_taken_in_comments() {
    let large = vec![b' '; MAX_BYTES as usize + 1];
    let told = SceneFile::parse(Path::new("x.NFF"), large).expect_err("it is too large").to_string();
    assert!(told.contains("more than 16777216 bytes"), "{told}");
    let latin = [b"# Gr\xfcn\n", FILE.as_bytes()].concat();
    assert!(SceneFile::parse(Path::new("x.NFF"), latin).is_ok());
}
