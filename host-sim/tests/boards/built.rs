//! Building a project as its README says, for its chip.

use crate::project::Project;
use host_sim::boards::{BOARDS, Board, Source};
use object::{Object, ObjectSection, SectionFlags, SectionKind, elf};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Begins a project for a board, builds it in the versions that come with it, and answers the image.
///
/// All boards share a folder for what is built, so that what they have in common is built once.
pub fn image(board: &'static Board) -> PathBuf {
    let name = format!("{}-show", board.name);
    let project = Project::called(&name, board, &Source::here());
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("projects");
    let output = Command::new(env!("CARGO"))
        .args(["build", "--release", "--locked", "--target-dir"])
        .arg(&target)
        .current_dir(&project.folder)
        // These would take the place of the link arguments of the project.
        .env_remove("RUSTFLAGS")
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .output()
        .expect("cargo does not start");
    assert!(output.status.success(), "{}:\n{}", board.name, String::from_utf8_lossy(&output.stderr));
    let image = target.join(board.target).join("release").join(name);
    let [flash, ram] = sizes(&image);
    println!("{}: {flash} bytes of flash, {ram} of static RAM", board.name);
    image
}

/// Counts the bytes of an image in flash, and in RAM without its stack.
fn sizes(image: &Path) -> [u64; 2] {
    let bytes = fs::read(image).unwrap_or_else(|error| panic!("{}: {error}", image.display()));
    let elf = object::File::parse(&*bytes).expect("the image is no ELF file");
    let mut sizes = [0; 2];
    // What an ESP32's script leaves to the stack is a section too.
    for section in elf.sections().filter(|section| section.name() != Ok(".stack")) {
        let SectionFlags::Elf { sh_flags } = section.flags() else { continue };
        let [held, writable] = [elf::SHF_ALLOC, elf::SHF_WRITE].map(|flag| sh_flags & u64::from(flag) != 0);
        let zeroed = section.kind() == SectionKind::UninitializedData;
        sizes[0] += if held && !zeroed { section.size() } else { 0 };
        sizes[1] += if held && writable { section.size() } else { 0 };
    }
    sizes
}

#[test]
#[ignore = "needs the firmware's targets (run by .ci/run)"]
fn boards_that_no_emulator_has_are_built_for_their_chips() {
    for board in BOARDS.iter().filter(|board| board.emulator.is_none()) {
        image(board);
    }
}
