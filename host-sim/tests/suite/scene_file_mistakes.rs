//! What a scene file's author is told: what is wrong, in which line, and what was probably meant.

use host_sim::scene_file::file::MAX_BYTES;
use host_sim::scene_file::read::MAX_COUNT;
use host_sim::scene_file::{Complaint, Mistake, Reason, SceneFile, parse};
use std::fmt::Write;
use std::path::Path;

/// Is a scene without a mistake, its parts a line each.
const SCENE: &str = r#"Scene(
    size: (64, 48),
    camera: (eye: (0, 1, 4), center: (0, 0, 0), projection: Perspective(fovy: 40)),
    settings: (depth: 2),
    sky: Gradient(nadir: 1, zenith: (0.5, 0.7, 1)),
    materials: {
        "red": (color: (0.9, 0.1, 0.1), mirror: 0.2),
        "dull": (color: 0.5),
    },
    lights: [
        Point(position: (3, 5, 4), color: 1),
    ],
    objects: [
        // Grün is not among them.
        (shape: Sphere(center: (0, 0, 0), radius: 1), material: "red"),
        (shape: Plane(point: (0, -1, 0), normal: (0, 1, 0)), material: "dull"),
    ],
)
"#;

/// Reads the scene with one piece of its text replaced.
fn complaint(piece: &str, by: &str) -> Box<Complaint> {
    assert_eq!(SCENE.matches(piece).count(), 1, "{piece}");
    let text = SCENE.replace(piece, by).into_bytes();
    match SceneFile::parse(Path::new("my/scene.ron"), text) {
        Ok(_) => panic!("{by} is taken for {piece}"),
        Err(complaint) => complaint,
    }
}

/// Demands a first line, and that this text is underlined in this line of the file.
fn assert_told(piece: &str, by: &str, title: &str, underlined: (usize, &str)) {
    let told = complaint(piece, by).to_string();
    let lines: Vec<&str> = told.lines().collect();
    let (number, what) = underlined;
    assert_eq!(lines[0], title, "{told}");
    assert!(lines[1].contains(&format!("my/scene.ron:{number}:")), "{told}");
    let carets = lines[4].find('^').unwrap_or_else(|| panic!("nothing is underlined: {told}"));
    assert!(lines[3][carets..].starts_with(what), "not {what}: {told}");
    assert_eq!(lines[4].matches('^').count(), what.chars().count(), "{told}");
}

#[test]
fn the_scene_has_no_mistake() {
    let file = SceneFile::parse(Path::new(""), SCENE.as_bytes().to_vec());
    assert!(file.is_ok(), "{}", file.unwrap_err());
}

#[test]
fn a_misspelt_name_is_shown_with_the_one_that_was_meant() {
    let red = "material: \"red\"";
    let title = "unknown material `rde`, did you mean `red`?";
    assert_told(red, "material: \"rde\"", title, (15, "rde"));
    assert_told("(color: 0.5)", "(colr: 0.5)", "unknown field `colr`, did you mean `color`?", (8, "colr"));
    let title = "unknown shape `sphere`, did you mean `Sphere`?";
    assert_told("Sphere(", "sphere(", title, (15, "sphere"));
    assert_told("lights:", "light:", "unknown field `light`, did you mean `lights`?", (10, "light"));
    assert_told("Point(", "Lamp(", "unknown light `Lamp`", (11, "Lamp"));
    let told = complaint("Point(", "Lamp(").to_string();
    assert!(told.ends_with("help: Light has `Point`, `Directional`, `Spot`"), "{told}");
}

#[test]
fn a_name_with_escapes_is_missed_too() {
    let told = complaint("\"red\"),", "\"r\\u{65}x\"),").to_string();
    assert!(told.starts_with("unknown material `rex`, did you mean `red`?"), "{told}");
    assert!(told.contains("scene.ron:15:9"), "{told}");
}

#[test]
fn what_the_core_refuses_is_shown_in_its_line() {
    let ball = "(shape: Sphere(center: (0, 0, 0), radius: -1), material: \"red\")";
    assert_told("radius: 1", "radius: -1", "object 0: its radius is not above zero", (15, ball));
    let red = "(color: (0.9, 0.1, 0.1), mirror: 1.2)";
    let title = "material 0: its mirror weight is not between 0 and 1";
    assert_told("mirror: 0.2", "mirror: 1.2", title, (7, red));
    let told = [
        ("color: 1)", "color: -1)", "light 0: ", 11),
        ("nadir: 1,", "up: (1, 1, 0), nadir: 1,", "sky: ", 5),
        ("settings:", "ambient: NaN, settings:", "ambient light: ", 4),
        ("eye: (0, 1, 4)", "eye: (0, 0, 0)", "camera: eye and center coincide", 3),
        ("depth: 2", "depth: 33", "a depth of 33 ", 4),
        ("depth: 2", "exposure: -2", "the exposure ", 4),
    ];
    for (piece, by, title, line) in told {
        let told = complaint(piece, by).to_string();
        assert!(told.starts_with(title), "{told}");
        assert!(told.contains(&format!("scene.ron:{line}:")), "{told}");
    }
}

#[test]
fn a_number_too_small_for_a_scene_says_which_line_is_too_large() {
    let text = SCENE.replace("radius: 1", "radius: 5000");
    let file = SceneFile::parse(Path::new("big.ron"), text.into_bytes()).expect("f64 has room for it");
    let lists = file.description().lists::<scanray::Fixed>();
    let fault = file.description().scene(&lists).check().expect_err("fixed point has no room for it");
    let told = file.explain(fault.into()).to_string();
    assert!(told.starts_with("object 0: ") && told.contains("big.ron:15:9"), "{told}");
}

#[test]
fn values_of_another_kind_are_shown_where_they_stand() {
    assert_told("radius: 1", "radius: \"one\"", "expected float", (15, "\""));
    assert_told("(64, 48)", "(64, 0)", "a picture has 1 to 4096 pixels along each side", (2, "(64, 0)"));
    assert_told(
        "(64, 48)",
        "(64, 4097)",
        "a picture has 1 to 4096 pixels along each side",
        (2, "(64, 4097)"),
    );
    let twice = "the field `radius` is there twice";
    assert_told("radius: 1", "radius: 1, radius: 2", twice, (15, "radius"));
    assert_told(", radius: 1", "", "the field `radius` is missing", (15, ")"));
    let paint = "a material has either `color` or `texture`";
    assert_told("(color: 0.5)", "()", paint, (8, "()"));
    assert_told("\"dull\":", "\"red\":", "there are two materials `red`", (8, "red"));
}

#[test]
fn a_file_that_is_too_large_or_no_text_is_refused() {
    let of = |bytes| SceneFile::parse(Path::new("x.ron"), bytes).unwrap_err();
    let large = of(vec![b' '; MAX_BYTES as usize + 1]);
    assert_eq!(large.mistake, Mistake { reason: Reason::TooLarge(MAX_BYTES), place: None });
    assert!(large.to_string().contains("x.ron"), "{large}");
    assert_eq!(of(b"Scene(\xff".to_vec()).mistake.reason, Reason::NotText(6));
}

#[test]
fn a_list_longer_than_the_core_can_number_is_refused_at_the_first_thing_too_many() {
    let mut text =
        String::from("(camera: (eye: (0, 0, 1), center: (0, 0, 0), projection: Perspective(fovy: 9)), ");
    text.push_str("materials: {\"a\": (color: 1)}, objects: [\n");
    let object = "(shape: Sphere(center: (0, 0, 0), radius: 1), material: \"a\"),";
    for _ in 0..MAX_COUNT {
        writeln!(text, "{object}").unwrap();
    }
    let full = text.clone() + "])";
    assert_eq!(parse(&full).map(|(scene, _)| scene.objects.len()), Ok(MAX_COUNT));
    let mistake = parse(&(text.clone() + object + "])")).map(|_| ()).unwrap_err();
    assert_eq!(mistake.reason, Reason::TooMany(MAX_COUNT));
    assert_eq!(mistake.place.map(|place| place.start), Some(text.len()));
}
