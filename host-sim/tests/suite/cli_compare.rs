//! `scanray compare` as a user and as a script meets it.

use scanray::gallery::Gallery;
use serde_json::Value;
use std::path::PathBuf;
use std::process::Command;

const KEYS: [&str; 9] =
    ["number", "over_1", "over_8", "panel", "psnr_all_db", "psnr_db", "scene", "silhouette", "worst"];

fn desk(test: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("scanray-compare-{test}-{}", std::process::id()));
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Runs a comparison in a directory of its own; answers what it prints and the files it leaves.
fn compare(test: &str, arguments: &str) -> (String, Vec<(String, [u32; 2])>) {
    let desk = desk(test);
    let mut command = Command::new(env!("CARGO_BIN_EXE_scanray"));
    let output =
        command.arg("compare").args(arguments.split_whitespace()).current_dir(&desk).output().unwrap();
    assert!(output.status.success(), "{arguments}: {output:?}");
    let entries = std::fs::read_dir(&desk).unwrap().map(|entry| entry.unwrap().path());
    let files = entries.map(|path| {
        let size = image::image_dimensions(&path).map_or([0, 0], |(w, h)| [w, h]);
        (path.file_name().unwrap().to_string_lossy().into_owned(), size)
    });
    let files = files.collect();
    std::fs::remove_dir_all(&desk).unwrap();
    (String::from_utf8(output.stdout).unwrap(), files)
}

#[test]
fn json_is_an_array_of_figures_with_exactly_the_promised_keys() {
    let (text, files) = compare("json", "--all --json --size 24x18");
    let all: Vec<Value> = serde_json::from_str(&text).unwrap();
    for figures in &all {
        let mut keys: Vec<&str> = figures.as_object().unwrap().keys().map(String::as_str).collect();
        keys.sort_unstable();
        assert_eq!(keys, KEYS);
        assert_eq!(figures["panel"], "rgb888");
        assert!(figures["psnr_db"].as_f64().unwrap() > 45.0, "{figures}");
    }
    let pairs: Vec<_> =
        all.iter().map(|f| (f["scene"].as_str().unwrap(), f["number"].as_str().unwrap())).collect();
    let expected: Vec<_> =
        f32::views().iter().flat_map(|view| ["f32", "fixed", "exact"].map(|n| (view.name, n))).collect();
    assert_eq!(pairs, expected);
    assert_eq!(files, [], "a script that asks for figures gets no files");
}

#[test]
fn a_single_scene_gets_a_table_and_a_picture_of_all_numbers_and_differences() {
    let (text, files) = compare("single", "simple --size 60x40");
    for number in ["f32", "fixed", "exact"] {
        assert!(text.lines().any(|line| line.starts_with("simple") && line.contains(number)), "{text}");
    }
    // Four pictures in two rows, with gaps of 4 and labels of 14.
    assert_eq!(files, [("simple-compare.png".to_owned(), [4 * 64 + 4, 2 * 54 + 4])]);
}

#[test]
fn one_number_and_another_panel_can_be_asked_for() {
    let (text, _) = compare("one", "simple --size 16x12 --number fixed --panel mono --json");
    let all: Vec<Value> = serde_json::from_str(&text).unwrap();
    assert_eq!(all.len(), 1);
    assert_eq!((&all[0]["number"], &all[0]["panel"]), (&Value::from("fixed"), &Value::from("mono")));
}

#[test]
fn a_directory_for_the_pictures_is_made() {
    let desk = desk("directory");
    let mut command = Command::new(env!("CARGO_BIN_EXE_scanray"));
    command.args(["compare", "--all", "--size", "8x8", "--json", "-o", "a/b"]).current_dir(&desk);
    assert!(command.output().unwrap().status.success());
    for view in f32::views() {
        assert!(desk.join("a/b").join(format!("{}-compare.png", view.name)).exists(), "{}", view.name);
    }
    std::fs::remove_dir_all(&desk).unwrap();
}

#[test]
fn adaptive_pictures_are_compared_with_exact_ones_and_keep_the_promise() {
    let arguments = "--all --number f32 --quality adaptive --panel rgb565 --size 320x240 --json";
    let (text, files) = compare("adaptive", arguments);
    let all: Vec<Value> = serde_json::from_str(&text).unwrap();
    let names: Vec<_> = all.iter().map(|kept| kept["scene"].as_str().unwrap()).collect();
    assert_eq!(names, f32::views().iter().map(|view| view.name).collect::<Vec<_>>());
    for kept in &all {
        let figure = |key: &str| kept[key].as_f64().unwrap();
        assert!(figure("over_two_steps") <= 0.005 && figure("worst") <= 28.5 / 31.0, "{kept}");
        // Pixels left out may be the dearer ones: their share of the rays is about that of the pixels.
        assert!(figure("traced") < 0.5 && figure("traced") <= figure("rays") + 0.05, "{kept}");
    }
    assert!(all.iter().any(|kept| kept["worst"].as_f64() > Some(0.0)), "{text}");
    assert_eq!(files, []);
}

#[test]
fn pictures_sampled_on_edges_are_compared_with_those_sampled_everywhere() {
    let (text, _) = compare("edges", "c-ray --number f32 --samples 3 --adaptive-samples --size 96x72 --json");
    let all: Vec<Value> = serde_json::from_str(&text).unwrap();
    let figure = |key: &str| all[0][key].as_f64().unwrap();
    assert!(figure("over_two_steps") < 0.02, "{text}");
    assert!(figure("traced") > 1.0 / 9.0 && figure("traced") < 0.5, "{text}");
}

#[test]
fn several_rays_a_pixel_are_judged_by_several_of_the_reference() {
    let figures = |test: &str, options: &str| {
        let (text, _) = compare(test, &format!("c-ray --number exact --size 48x36 --json {options}"));
        let all: Vec<Value> = serde_json::from_str(&text).unwrap();
        all[0]["psnr_all_db"].as_f64().unwrap()
    };
    // Silhouettes count: one ray of the reference would not be near.
    assert!(figures("samples", "--samples 3") > 60.0);
    assert!(figures("jitter", "--samples 3 --jitter") < 45.0);
}
