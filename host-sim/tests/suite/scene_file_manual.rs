//! The manual of scene files is right: its examples are scenes, and every word of the format is in it.

use host_sim::scene_file::{Reason, SceneFile, parse};
use scanray::Fixed;
use std::path::Path;

const MANUAL: &str = include_str!("../../../docs/scene-format.md");

/// Answers the fenced blocks of a kind.
fn blocks(kind: &str) -> Vec<String> {
    let fence = format!("\n```{kind}\n");
    let after = MANUAL.split(&fence).skip(1);
    after.map(|rest| rest.split("\n```").next().unwrap_or_default().to_owned() + "\n").collect()
}

const CAMERA: &str = "camera: (eye: (0, 0, 5), center: (0, 0, 0), projection: Perspective(fovy: 40)),";

/// Makes a scene of an example that is some fields of one.
fn whole(example: &str) -> String {
    if example.contains("Scene(") {
        example.to_owned()
    } else {
        format!("Scene({}{example})", if example.contains("camera:") { "" } else { CAMERA })
    }
}

#[test]
fn every_example_is_a_scene_that_can_be_drawn() {
    let examples = blocks("ron");
    assert!(examples.len() >= 10, "only {} examples were found", examples.len());
    for example in examples {
        // The images, meshes and voxels of the examples lie beside the scenes.
        let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/manual.ron");
        let file = SceneFile::parse(&beside, whole(&example).into_bytes());
        let file = file.unwrap_or_else(|complaint| panic!("{complaint}\nin {example}"));
        let lists = file.description().lists::<Fixed>();
        assert_eq!(file.description().scene(&lists).check(), Ok(()), "{example}");
    }
}

#[test]
fn the_defaults_are_those_of_the_smallest_scene() {
    let examples = blocks("ron");
    let smallest = examples.iter().position(|example| example.starts_with("Scene(camera:"));
    let smallest = smallest.expect("the smallest scene is there");
    let [smallest, spelt_out] =
        [&examples[smallest], &examples[smallest + 1]].map(|text| parse(text).unwrap().0);
    assert_eq!((&smallest.about, smallest.size), (&spelt_out.about, spelt_out.size));
    assert_eq!(smallest.camera.in_number::<Fixed>(), spelt_out.camera.in_number());
    assert_eq!(smallest.settings.in_number::<Fixed>(), spelt_out.settings.in_number());
    let lists = smallest.lists::<Fixed>();
    assert_eq!(smallest.scene(&lists), spelt_out.scene(&lists));
}

#[test]
fn the_mistake_is_told_as_the_manual_says() {
    let (wrong, told) = (blocks("ron wrong"), blocks("text"));
    let complaint = SceneFile::parse(Path::new("ball.ron"), wrong.concat().into_bytes()).unwrap_err();
    assert_eq!(told, [complaint.to_string() + "\n"]);
}

/// Answers the words that are known where an unknown one stands.
fn known(fields: &str) -> &'static [&'static str] {
    match parse(&whole(fields)).map(|_| ()).unwrap_err().reason {
        Reason::Form(ron::Error::NoSuchStructField { expected, .. }) => expected,
        Reason::Form(ron::Error::NoSuchEnumVariant { expected, .. }) => expected,
        other => panic!("{fields}: {other}"),
    }
}

/// Answers the variants known in the place of `?`, and the fields of each.
fn known_with_fields(fields: &str) -> Vec<&'static str> {
    let variants = known(&fields.replace('?', "Unknown()"));
    let of_variant = |variant: &&str| known(&fields.replace('?', &format!("{variant}(unknown: 1)")));
    variants.iter().chain(variants.iter().flat_map(of_variant)).copied().collect()
}

#[test]
fn every_word_of_the_format_is_in_the_manual() {
    let structs = [
        "unknown: 1",
        "camera: (unknown: 1)",
        "settings: (unknown: 1)",
        "materials: { \"a\": (unknown: 1) }",
        "objects: [(unknown: 1)]",
        "objects: [(shape: SmoothTriangle(a: (unknown: 1)))]",
        "objects: [(shape: Polygon(vertices: [], normal: (0, 0, 1), rule: Unknown))]",
        "settings: (transfer: Unknown)",
        "settings: (dither: Unknown)",
        "materials: { \"a\": (model: Unknown) }",
        "materials: { \"a\": (texture: Image(filter: Unknown)) }",
        "materials: { \"a\": (bump: Heights(image: (unknown: 1))) }",
        "materials: { \"a\": (glass: (unknown: 1)) }",
        "materials: { \"a\": (glass: (fresnel: Unknown)) }",
        "objects: [(shape: Mesh(accel: Unknown))]",
        "objects: [(shape: Mesh(corners: Unknown))]",
        "objects: [(shape: Mesh(corners: Steps(unknown: 1)))]",
        "objects: [(shape: Isosurface(grid: (unknown: 1)))]",
        "objects: [(shape: Isosurface(gradient: Unknown))]",
        "volume: (unknown: 1)",
        "volume: (classes: [(unknown: 1)])",
        "volume: (reconstruction: Unknown)",
    ];
    let enums = [
        "camera: (projection: ?)",
        "sky: ?",
        "materials: { \"a\": (texture: ?) }",
        "materials: { \"a\": (bump: ?) }",
        "lights: [?]",
        "objects: [(shape: ?)]",
    ];
    let words = structs.iter().flat_map(|fields| known(fields).to_vec());
    let words: Vec<&str> = words.chain(enums.iter().flat_map(|fields| known_with_fields(fields))).collect();
    assert!(words.len() > 60, "{words:?}");
    let missing: Vec<_> = words.iter().filter(|word| !MANUAL.contains(&format!("`{word}`"))).collect();
    assert!(missing.is_empty(), "the manual does not say {missing:?}");
}
