//! What a project holds.

use host_sim::boards::{BOARDS, Board, Source, create};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Is a project, gone with its folder when it is dropped.
pub struct Project {
    /// Where it lies.
    pub folder: PathBuf,
    _beside: TempDir,
}

impl Project {
    /// Begins a project for a board in a folder of a test's own.
    pub fn new(board: &'static Board, source: &Source) -> Self {
        Self::called("ball-show", board, source)
    }

    /// Begins a project of that name.
    pub fn called(name: &str, board: &'static Board, source: &Source) -> Self {
        let beside = TempDir::new().expect("there is no room for a folder");
        let folder = beside.path().join(name);
        let said =
            create(board, &folder, source).unwrap_or_else(|refusal| panic!("{}: {refusal}", board.name));
        assert_eq!(said, name);
        Self { folder, _beside: beside }
    }

    /// Answers the text of each of its files.
    pub fn texts(&self) -> BTreeMap<String, String> {
        let mut texts = BTreeMap::new();
        collect(&self.folder, &self.folder, &mut texts);
        texts
    }
}

fn collect(root: &Path, folder: &Path, texts: &mut BTreeMap<String, String>) {
    for entry in fs::read_dir(folder).expect("a folder that cannot be read") {
        let path = entry.expect("a folder that cannot be read").path();
        if path.is_dir() {
            collect(root, &path, texts);
        } else {
            let name = path.strip_prefix(root).expect("it lies there").to_str().expect("a plain name");
            texts.insert(name.to_owned(), fs::read_to_string(&path).expect("a file that is no text"));
        }
    }
}

#[test]
fn a_project_has_all_that_firmware_is_made_of_and_nothing_of_the_crate_it_was_copied_from() {
    for board in &BOARDS {
        let texts = Project::new(board, &Source::here()).texts();
        for file in [
            ".cargo/config.toml",
            ".gitignore",
            "Cargo.lock",
            "Cargo.toml",
            "README.md",
            "src/board.rs",
            "src/main.rs",
            "src/scene.rs",
        ] {
            assert!(texts.contains_key(file), "{}: no {file}", board.name);
        }
        // The linker script of an ESP32 comes with its crate.
        assert_eq!(texts.contains_key("memory.x"), board.name != "esp32c3", "{}", board.name);
        assert!(texts["README.md"].starts_with("# ball-show\n"), "{}", board.name);
        for (file, text) in &texts {
            assert!(!text.contains("my-picture") && !text.contains("../../.."), "{}: {file}", board.name);
        }
    }
}

#[test]
fn a_project_is_built_for_its_board_and_started_by_what_the_list_says() {
    for board in &BOARDS {
        let texts = Project::new(board, &Source::here()).texts();
        let config = &texts[".cargo/config.toml"];
        assert!(config.contains(&format!("target = \"{}\"", board.target)), "{}: {config}", board.name);
        assert!(config.contains(&format!("runner = \"{}\"", board.flash)), "{}: {config}", board.name);
        assert!(
            texts["README.md"].contains(&format!("rustup target add {}\n", board.target)),
            "{}",
            board.name
        );
    }
}

#[test]
fn a_project_depends_on_the_sources_at_hand_or_on_the_published_crate() {
    for board in &BOARDS {
        let toml = &Project::new(board, &Source::here()).texts()["Cargo.toml"];
        let line = toml.lines().find(|line| line.starts_with("scanray")).expect("it depends on scanray");
        let path = line.split('"').nth(1).expect("a path");
        assert!(Path::new(path).join("src/lib.rs").is_file(), "{line}");

        let toml = &Project::new(board, &Source::Published).texts()["Cargo.toml"];
        assert!(toml.contains("\nscanray = \"0.1\"\n"), "{toml}");
    }
}

#[test]
fn boards_that_compute_alike_begin_with_the_same_scene() {
    for number in ["f32", "fixed"] {
        let boards = BOARDS.iter().filter(|board| board.number == number);
        let scenes: Vec<_> = boards
            .map(|board| {
                Project::new(board, &Source::here()).texts().remove("src/scene.rs").expect("a scene")
            })
            .collect();
        assert!(scenes.len() > 1 && scenes.windows(2).all(|pair| pair[0] == pair[1]), "{number}");
    }
}

#[test]
fn what_drives_the_oled_is_what_the_example_proves() {
    let board = host_sim::boards::find("lm3s6965evb").expect("a board");
    let texts = Project::new(board, &Source::here()).texts();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/lm3s6965_oled/firmware");
    for file in ["ssd0323.rs", "registers.rs"] {
        let proven = fs::read_to_string(example.join(file)).expect("the example has it");
        assert!(texts[&format!("src/{file}")] == proven, "{file}");
    }
}
