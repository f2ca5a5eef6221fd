//! The command line as a user meets it: the built program, its files, its answers.

use crate::desk::{Desk, assert_refused, read, stderr, stdout};
use scanray::gallery::Gallery;
use std::process::Command;

#[test]
fn without_arguments_it_draws_the_simple_scene_and_tells_what_it_did() {
    let desk = Desk::new("bare");
    let output = desk.run("");
    assert!(output.status.success(), "{output:?}");
    assert_eq!(desk.files(), ["simple.png"]);
    assert_eq!(read(&desk.0.join("simple.png")).1, [240, 240]);
    let text = stdout(&output);
    for word in ["57,600 primary", "shadow", "rays/s", "1804 bytes", "dB PSNR", "/255", "simple.png"] {
        assert!(text.contains(word), "no {word:?} in {text}");
    }
    assert!(!text.contains('\u{1b}'), "escapes in what is no terminal: {text}");
}

#[test]
fn an_alias_may_hand_on_a_second_separator() {
    let desk = Desk::new("separator");
    let output = desk.run("-- render simple --size 8x8");
    assert!(output.status.success(), "{output:?}");
    assert_eq!(desk.files(), ["simple.png"]);
}

#[test]
fn no_window_opens_and_no_file_appears_elsewhere_when_nobody_sits_at_a_terminal() {
    let desk = Desk::new("unattended");
    let mut command = Command::new(env!("CARGO_BIN_EXE_scanray"));
    // A display that does not exist would make an attempt show in the output.
    let output = command
        .args(["render", "--size", "8x8"])
        .current_dir(&desk.0)
        .env("DISPLAY", ":9999")
        .output()
        .unwrap();
    assert!(output.status.success(), "{output:?}");
    assert!(!stdout(&output).contains("window"), "{}", stdout(&output));
    assert_eq!(stderr(&output), "");
}

#[test]
fn the_list_names_every_scene_with_its_size_and_what_it_shows() {
    let output = Desk::new("list").run("list");
    let text = stdout(&output);
    for (view, line) in f32::views().iter().zip(text.lines()) {
        let [columns, rows] = view.size;
        assert!(line.starts_with(view.name) && line.contains(&format!("{columns}x{rows}")), "{line}");
        assert!(line.ends_with(view.about), "{line}");
    }
    assert_eq!(text.lines().count(), f32::views().len());
}

#[test]
fn an_exported_scene_draws_the_picture_of_the_gallery() {
    let desk = Desk::new("export");
    let output = desk.run("export c-ray -o mine.ron");
    assert!(output.status.success(), "{output:?}");
    for number in ["f32", "fixed"] {
        for scene in ["c-ray", "mine.ron"] {
            let output = desk.run(&format!("render {scene} --number {number} --size 64x48"));
            assert!(output.status.success(), "{output:?}");
        }
        let [gallery, file] = ["c-ray.png", "mine.png"].map(|name| read(&desk.0.join(name)));
        assert!(gallery == file, "{number}");
    }
}

#[test]
fn a_scene_file_is_taken_wherever_a_scene_is() {
    let desk = Desk::new("file");
    assert!(desk.run("export simple").status.success());
    assert_eq!(desk.files(), ["simple.ron"]);
    let list = stdout(&desk.run("list simple.ron"));
    assert!(list.starts_with("simple  240x240  a ball, a floor") && list.lines().count() == 1, "{list}");
    let output = desk.run("compare simple.ron --size 24x18 --json");
    assert!(stdout(&output).contains("\"scene\": \"simple\""), "{output:?}");
    let again = desk.run("export simple.ron -o -");
    assert_eq!(stdout(&again), std::fs::read_to_string(desk.0.join("simple.ron")).unwrap());
    assert_refused(&desk, "show simple.ron", &["no display"]);
}

#[test]
fn images_are_written_beside_a_scene_and_found_from_any_directory() {
    let desk = Desk::new("images");
    let told = stdout(&desk.run("export bump -o mine.ron"));
    let files = ["mine-heights.png", "mine-normals.png", "mine.ron"];
    assert_eq!(desk.files(), files);
    let of_line = |line: &str| line.split_whitespace().last().map(str::to_owned);
    assert_eq!(told.lines().filter_map(of_line).collect::<Vec<_>>(), files);

    std::fs::create_dir(desk.0.join("elsewhere")).unwrap();
    let elsewhere = Desk(desk.0.join("elsewhere"));
    let path = desk.0.join("mine.ron");
    for file in ["../mine.ron", path.to_str().unwrap()] {
        let list = stdout(&elsewhere.run(&format!("list {file}")));
        assert!(list.starts_with("mine  320x240  an orange, a golf ball"), "{list}");
    }
    for render in ["bump -o bump.png", "../mine.ron -o mine.png"] {
        let output = elsewhere.run(&format!("render {render} --number fixed --size 64x48"));
        assert!(output.status.success(), "{output:?}");
    }
    let [gallery, file] = ["bump.png", "mine.png"].map(|name| read(&elsewhere.0.join(name)));
    assert!(gallery == file);

    let says = ["the scene has images, meshes or voxels", "-o FILE.ron"];
    assert_refused(&desk, "export bump -o -", &says);
    assert_refused(&desk, "export mine.ron -o -", &says);
    std::fs::remove_file(desk.0.join("mine-normals.png")).unwrap();
    let says = ["cannot read the image ../mine-normals.png: there is no such file", "../mine.ron:20:", "^^^"];
    assert_refused(&elsewhere, "render ../mine.ron", &says);
}

#[test]
fn mistakes_of_a_scene_file_are_shown_with_their_line() {
    let desk = Desk::new("mistakes");
    assert!(desk.run("export simple").status.success());
    let text = std::fs::read_to_string(desk.0.join("simple.ron")).unwrap();
    std::fs::write(desk.0.join("field.ron"), text.replace("radius", "raduis")).unwrap();
    std::fs::write(desk.0.join("large.ron"), text.replace("radius: 25", "radius: 2500")).unwrap();
    let line = [":28:", "(shape: Sphere", "^^^^^^"];
    let says =
        ["error: unknown field `raduis`, did you mean `radius`?", "field.ron", line[0], line[1], line[2]];
    assert_refused(&desk, "render field.ron", &says);
    let says = ["error: object 0: ", "too large for the number type", "large.ron", line[0], line[1], line[2]];
    assert_refused(&desk, "render large.ron --number fixed", &says);
    assert_refused(&desk, "compare large.ron --number fixed", &says);
    assert_refused(&desk, "render none.ron", &["cannot read none.ron"]);
    assert_refused(&desk, "export simple -o no/such/place.ron", &["no/such/place.ron", "-o"]);
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let mut command = Command::new(env!("CARGO_BIN_EXE_scanray"));
    let child = command.arg("list").stdout(writer).stderr(std::process::Stdio::piped()).spawn().unwrap();
    drop(command);
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{output:?}");
    assert_eq!(stderr(&output), "");
}

#[test]
fn wrong_words_are_refused_with_a_way_out() {
    let desk = Desk::new("wrong");
    assert_refused(&desk, "render simpel", &["no scene 'simpel'", "did you mean 'simple'", "scanray list"]);
    assert_refused(&desk, "render --size 240", &["320x240"]);
    assert_refused(&desk, "render --size 0x5", &["320x240"]);
    assert_refused(&desk, "render --size 99999x5", &["4096", "320x240"]);
    assert_refused(&desk, "render --depth 33", &["from 0 to 32"]);
    assert_refused(&desk, "render --step 3", &["3/72"]);
    assert_refused(&desk, "render --panel rgb555", &["rgb565"]);
    assert_refused(&desk, "render --dither floyd", &["blue-noise", "diffused"]);
    assert_refused(&desk, "render --samples 9", &["from 1 to 8"]);
    assert_refused(&desk, "render --samples 0", &["from 1 to 8"]);
    assert_refused(&desk, "render --jitter", &["--samples"]);
    assert_refused(&desk, "render --samples 2 --quality adaptive", &["--quality"]);
    assert_refused(&desk, "progressive --quality adaptive", &["step by step"]);
    assert_refused(&desk, "progressive --number oracle", &["step by step"]);
    assert_refused(&desk, "progressive --approach raster", &["step by step"]);
    assert_refused(&desk, "progressive --size 8x8 -o no/such/place.gif", &["no/such/place.gif", "-o"]);
    assert_refused(&desk, "compare", &["no scene to compare", "--all"]);
    assert_refused(&desk, "compare simple --number oracle", &["f32, fixed and exact"]);
    assert_refused(&desk, "draw", &["draw", "--help"]);
    assert_eq!(desk.files(), [""; 0]);
}

#[test]
fn what_cannot_be_written_is_said_with_its_place() {
    let desk = Desk::new("unwritable");
    assert_refused(&desk, "render --size 8x8 -o no/such/place.png", &["no/such/place.png", "-o"]);
    assert_refused(&desk, "render --size 8x8 -o .", &["cannot write .", "-o"]);
    std::fs::write(desk.0.join("taken"), "").unwrap();
    assert_refused(&desk, "compare simple --size 8x8 -o taken", &["taken", "-o"]);
}

#[test]
fn a_window_without_a_display_is_refused_with_a_way_out() {
    assert_refused(&Desk::new("blind"), "show simple", &["no display", "scanray render"]);
}

#[test]
fn help_is_no_error_and_gives_examples() {
    let desk = Desk::new("help");
    let commands = [
        "",
        "render",
        "show",
        "progressive",
        "compare",
        "cost",
        "explain",
        "dither",
        "hierarchies",
        "list",
        "export",
        "bake",
        "gallery",
        "lesson",
        "serve",
        "new",
        "prove",
    ];
    for command in commands {
        let arguments = format!("{command} --help");
        let output = desk.run(&arguments);
        assert!(output.status.success(), "{arguments}");
        assert!(stdout(&output).contains("Examples:"), "{arguments}");
    }
}
