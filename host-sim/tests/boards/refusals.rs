//! What is not begun, and why.

use host_sim::boards::{Refusal, Source, create, find};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

fn pico(folder: &Path) -> Result<String, Refusal> {
    create(find("pico").expect("a board"), folder, &Source::here())
}

fn desk() -> TempDir {
    TempDir::new().expect("there is no room for a folder")
}

/// Runs the program as a user does.
fn scanray(desk: &TempDir, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_scanray")).args(arguments).current_dir(desk).output().expect("it starts")
}

fn files(desk: &TempDir) -> usize {
    fs::read_dir(desk).expect("a folder").count()
}

#[test]
fn what_is_there_already_is_refused_and_not_touched() {
    let desk = desk();
    let file = desk.path().join("ball");
    fs::write(&file, "mine").expect("there is room");
    assert!(matches!(pico(&file), Err(Refusal::Exists(path)) if path == file));
    assert_eq!(fs::read_to_string(&file).expect("it is there"), "mine");

    let folder = desk.path().join("show");
    fs::create_dir(&folder).expect("there is room");
    assert!(matches!(pico(&folder), Err(Refusal::Exists(_))));
    assert_eq!(fs::read_dir(&folder).expect("it is there").count(), 0);
}

/// The manual's own example is the name that stands in the templates.
#[test]
fn a_project_may_be_called_as_the_templates_are() {
    let desk = desk();
    assert_eq!(pico(&desk.path().join("my-picture")).expect("a project"), "my-picture");
}

#[test]
fn a_folder_whose_name_no_crate_can_have_is_refused() {
    let desk = desk();
    for name in ["2balls", "my picture", "fn", "-x"] {
        assert!(matches!(pico(&desk.path().join(name)), Err(Refusal::NoCrateName(said)) if said == name));
    }
    assert!(matches!(pico(Path::new("..")), Err(Refusal::NoCrateName(_))));
    for name in ["scanray", "mipidsi", "cortex-m"] {
        assert!(matches!(pico(&desk.path().join(name)), Err(Refusal::TakenName(said)) if said == name));
    }
    assert_eq!(files(&desk), 0);
}

#[test]
fn a_project_inside_the_sources_or_without_them_is_refused() {
    let inside = Path::new(env!("CARGO_MANIFEST_DIR")).join("ball-show");
    assert!(matches!(pico(&inside), Err(Refusal::InsideSources(path)) if path == inside));
    assert!(!inside.exists());

    let desk = desk();
    let gone = desk.path().join("gone");
    let refused =
        create(find("pico").expect("a board"), &desk.path().join("ball"), &Source::Folder(gone.clone()));
    assert!(matches!(refused, Err(Refusal::NoSources(path)) if path == gone));
    assert_eq!(files(&desk), 0);
}

#[test]
fn a_folder_that_cannot_be_made_is_refused_by_its_path() {
    let desk = desk();
    let beside = desk.path().join("nowhere");
    assert!(matches!(pico(&beside.join("ball")), Err(Refusal::Write(path, _)) if path == beside));
}

#[test]
fn an_unknown_board_is_refused_with_the_list_and_the_one_that_was_meant() {
    assert!(matches!(find("pico3"), Err(Refusal::UnknownBoard(name)) if name == "pico3"));
    let desk = desk();
    let output = scanray(&desk, &["new", "--board", "microbit", "ball"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    for word in
        ["no board 'microbit'", "did you mean 'microbit-v2'?", "pico-embassy", "lm3s6965evb", "--list"]
    {
        assert!(said.contains(word), "no {word:?} in {said}");
    }
    assert_eq!(files(&desk), 0);
}

#[test]
fn the_program_lists_the_boards_and_says_what_to_type_after_it_has_begun_a_project() {
    let desk = desk();
    let said = String::from_utf8(scanray(&desk, &["new", "--list"]).stdout).expect("a text");
    for board in &host_sim::boards::BOARDS {
        for word in [board.name, board.chip, board.panel, board.target, board.flash] {
            assert!(said.contains(word), "no {word:?} in {said}");
        }
    }
    let output = scanray(&desk, &["new", "--board", "pico", "ball"]);
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{output:?}");
    for word in [
        "cd ball\n",
        "rustup target add thumbv6m-none-eabi\n",
        "cargo build --release\n",
        "boards/run rp2040",
        "probe-rs",
    ] {
        assert!(said.contains(word), "no {word:?} in {said}");
    }
    assert!(desk.path().join("ball/src/scene.rs").is_file());
}
