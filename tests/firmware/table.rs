//! What the images cost, as a table in `target/boards.md`.

use std::{fs, sync::Mutex};

use object::{Object, ObjectSection, SectionFlags, SectionKind, elf};

use crate::board::{Run, target_folder};

const HEAD: &str = "\
| image | target | picture | text | data | bss | stack | instructions/pixel | with the panel's driver |
|---|---|---|--:|--:|--:|--:|--:|--:|
";

static ROWS: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// Adds what `run` cost; the report's entry `instructions` counts those of the picture.
pub fn add(run: &Run, picture: &str, instructions: &str) {
    let size = Sizes::of(run);
    let row = format!(
        "| {} | {} | {picture} | {} | {} | {} | {} | {} | {} |\n",
        run.board.example,
        run.board.target,
        size.text,
        size.data,
        size.bss,
        run.value("stack").unwrap_or("-"),
        per_pixel(run, instructions),
        per_pixel(run, "with-panel"),
    );
    print!("{HEAD}{row}");
    let mut rows = ROWS.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    rows.push(row);
    rows.sort();
    fs::write(target_folder().join("boards.md"), HEAD.to_owned() + &rows.concat())
        .expect("no room for the table");
}

/// Answers the bytes that a run took of flash and of RAM, its stack at the deepest included.
pub fn memory(run: &Run) -> [u64; 2] {
    let size = Sizes::of(run);
    [size.text + size.data, size.data + size.bss + run.count("stack")]
}

/// Prints the cycles of a frame: each part alone, both one after the other, and as they were, side by side.
pub fn print_times(run: &Run) {
    let [tracing, transfer, frame] = ["tracing", "transfer", "frame"].map(|key| run.count(key));
    println!("| image | tracing | transfer | one after the other | side by side |\n|---|--:|--:|--:|--:|");
    println!("| {} | {tracing} | {transfer} | {} | {frame} |", run.board.example, tracing + transfer);
}

fn per_pixel(run: &Run, count: &str) -> String {
    let number = |key| run.value(key).and_then(|value| value.parse::<f64>().ok());
    match (number(count), number("pixels")) {
        (Some(count), Some(pixels)) => format!("{:.1}", count / pixels),
        _ => "-".into(),
    }
}

/// Bytes by where they live: in flash, in both, in RAM alone.
#[derive(Default)]
struct Sizes {
    text: u64,
    data: u64,
    bss: u64,
}

impl Sizes {
    fn of(run: &Run) -> Self {
        let path = run.value("image").expect("the report names no image");
        let bytes = fs::read(path).unwrap_or_else(|error| panic!("{path}: {error}"));
        let elf = object::File::parse(&*bytes).expect("the image is no ELF file");
        let mut sizes = Self::default();
        for section in elf.sections() {
            let SectionFlags::Elf { sh_flags } = section.flags() else { continue };
            if sh_flags & u64::from(elf::SHF_ALLOC) == 0 {
                continue;
            }
            *match section.kind() {
                SectionKind::UninitializedData => &mut sizes.bss,
                _ if sh_flags & u64::from(elf::SHF_WRITE) != 0 => &mut sizes.data,
                _ => &mut sizes.text,
            } += section.size();
        }
        sizes
    }
}
