//! Boards: building firmware for them, running it, and what a run leaves behind.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
    process::{Command, Output},
};

use object::{Object, ObjectSection, ObjectSymbol};

/// An example and the target whose board it is for.
pub struct Board {
    pub example: &'static str,
    pub target: &'static str,
}

/// A run that ended well.
pub struct Run {
    pub board: &'static Board,
    folder: PathBuf,
    report: BTreeMap<String, String>,
}

impl Run {
    /// Builds and runs the board's example with the command a user would give.
    pub fn of(board: &'static Board) -> Self {
        Self::of_frames(board, 1)
    }

    /// Builds and runs the board's example until it has drawn so many pictures.
    pub fn of_frames(board: &'static Board, frames: usize) -> Self {
        Self::asked_for(board, "FRAMES", frames)
    }

    /// Builds and runs the board's example until that much of its own time has passed.
    pub fn of_seconds(board: &'static Board, seconds: usize) -> Self {
        Self::asked_for(board, "SECONDS", seconds)
    }

    /// Builds and runs the board's example for a picture, and for one more after each of so many resets.
    pub fn of_resets(board: &'static Board, resets: usize) -> Self {
        Self::asked_for(board, "RESETS", resets)
    }

    /// Builds and runs the board's example, of which so much of something is asked.
    fn asked_for(board: &'static Board, what: &str, number: usize) -> Self {
        let folder = scratch(&format!("{}-{}", board.example, what.to_lowercase()));
        let _ = fs::remove_dir_all(&folder);
        let mut run = cargo("run", board);
        run.env("SCANRAY_BOARD_OUT", &folder).env(format!("SCANRAY_BOARD_{what}"), number.to_string());
        let output = run.output().expect("cargo does not start");
        assert!(output.status.success(), "{} failed:\n{}", board.example, said(&output));
        let report = read(&folder.join("report.txt"));
        let report = String::from_utf8(report).expect("the report is no text");
        let pairs = report.lines().filter_map(|line| line.split_once(' '));
        Self { board, folder, report: pairs.map(|(key, value)| (key.into(), value.into())).collect() }
    }

    /// A value of the report.
    pub fn value(&self, key: &str) -> Option<&str> {
        self.report.get(key).map(String::as_str)
    }

    /// A count of the report.
    pub fn count(&self, key: &str) -> u64 {
        let value = self.value(key).and_then(|value| value.parse().ok());
        value.unwrap_or_else(|| panic!("{} reports no count '{key}'", self.board.example))
    }

    /// The raw picture that the run left under `name`.
    pub fn picture(&self, name: &str) -> Vec<u8> {
        read(&self.folder.join(name))
    }
}

/// Runs the board's image with `instruction` in place of the first of `main`, and returns what it says on failing.
pub fn run_with_main_replaced(board: &Board, instruction: [u8; 2]) -> String {
    let built = cargo("build", board).output().expect("cargo does not start");
    assert!(built.status.success(), "{} does not build:\n{}", board.example, said(&built));
    let image = target_folder().join(board.target).join("release/examples").join(board.example);
    let mut bytes = read(&image);
    let at = offset_of_main(&bytes);
    bytes[at..at + 2].copy_from_slice(&instruction);

    let folder = scratch(&format!("{}-broken", board.example));
    fs::create_dir_all(&folder).expect("no room for a broken image");
    let broken = folder.join("image");
    fs::write(&broken, bytes).expect("no room for a broken image");
    let runner = Path::new(env!("CARGO_MANIFEST_DIR")).join("host-sim/boards/run");
    let name = board.example.split('_').next().unwrap_or_default();
    let output = Command::new(runner).arg(name).arg(broken).env("SCANRAY_BOARD_OUT", &folder).output();
    let output = output.expect("the board's runner does not start");
    assert!(!output.status.success(), "{} ran well although it is broken", board.example);
    said(&output)
}

/// Where in the image's file the code of `main` lies.
fn offset_of_main(image: &[u8]) -> usize {
    let elf = object::File::parse(image).expect("the image is no ELF file");
    let main = elf.symbol_by_name("main").expect("the image has no main");
    let section =
        elf.section_by_index(main.section_index().expect("main lies nowhere")).expect("main lies nowhere");
    let (offset, _) = section.file_range().expect("main is not in the file");
    // The lowest bit of a function's address only says that it is Thumb code.
    (offset + (main.address() & !1) - section.address()) as usize
}

fn cargo(command: &str, board: &Board) -> Command {
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .args([command, "--release", "--example", board.example, "--target", board.target])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        // These would take the place of the link arguments that the target's configuration gives.
        .env_remove("RUSTFLAGS")
        .env_remove("CARGO_ENCODED_RUSTFLAGS");
    cargo
}

/// The folder that cargo builds in: this test's own scratch folder is its `tmp`.
pub fn target_folder() -> &'static Path {
    Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("the scratch folder lies in the target folder")
}

fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("boards").join(name)
}

fn read(path: &Path) -> Vec<u8> {
    fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn said(output: &Output) -> String {
    [&output.stdout, &output.stderr].map(|stream| String::from_utf8_lossy(stream)).concat()
}
