//! Whatever a file holds, it is read or refused: nothing panics, and what is read is written as it was.

use crate::scene_folder::{anywhere, export};
use host_sim::scene_file::{SceneFile, describe, write};
use host_sim::scenes::{self, Entry};
use proptest::prelude::*;
use proptest::sample::Index;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// Is a change that somebody, or a broken disk, makes to a text.
#[derive(Clone, Debug)]
enum Change {
    /// Another byte in the place of one.
    Byte(Index, u8),
    /// A piece left out.
    Cut(Index, usize),
    /// A piece of the text put in somewhere else.
    Paste(Index, usize, Index),
    /// A word of the format, or something near it, put in.
    Word(Index, &'static str),
}

const WORDS: [&str; 24] = [
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "\"",
    "\\",
    "//",
    "/*",
    "*/",
    "r#",
    "#![enable(implicit_some)]",
    "Some(",
    "None",
    "NaN",
    "inf",
    "-0.0",
    "1e999",
    "9999999999999999999999",
    "\u{301}\u{202e}",
    "\r\n\t",
];

fn change() -> impl Strategy<Value = Change> {
    let place = any::<Index>;
    prop_oneof![
        (place(), any::<u8>()).prop_map(|(at, byte)| Change::Byte(at, byte)),
        (place(), 1_usize..40).prop_map(|(at, length)| Change::Cut(at, length)),
        (place(), 1_usize..40, place()).prop_map(|(from, length, to)| Change::Paste(from, length, to)),
        (place(), prop::sample::select(&WORDS[..])).prop_map(|(at, word)| Change::Word(at, word)),
    ]
}

fn apply(bytes: &mut Vec<u8>, change: &Change) {
    if bytes.is_empty() {
        return;
    }
    let piece = |at: &Index, length: usize| {
        let begin = at.index(bytes.len());
        begin..bytes.len().min(begin + length)
    };
    match change {
        Change::Byte(at, byte) => {
            let at = at.index(bytes.len());
            bytes[at] = *byte;
        }
        Change::Cut(at, length) => drop(bytes.drain(piece(at, *length))),
        Change::Paste(from, length, to) => {
            let copy = bytes[piece(from, *length)].to_vec();
            let to = to.index(bytes.len());
            bytes.splice(to..to, copy);
        }
        Change::Word(at, word) => {
            let at = at.index(bytes.len());
            bytes.splice(at..at, word.bytes());
        }
    }
}

/// Reads bytes as a user's file; a complaint is shown, a scene is written and read again.
fn use_as_file(bytes: Vec<u8>) {
    match SceneFile::parse(&FOLDER.join("x.ron"), bytes) {
        Err(complaint) => assert!(!complaint.to_string().is_empty()),
        Ok(file) => {
            let text = write(file.description()).expect("what was read can be written");
            let again = SceneFile::parse(&FOLDER.join("x.ron"), text.clone().into_bytes());
            let again = again.unwrap_or_else(|complaint| panic!("{complaint} in {text}"));
            let said = |file: &SceneFile| anywhere(&format!("{:?}", file.description()));
            assert_eq!(said(&again), said(&file), "{text}");
            for error in [scanray::RenderError::Exposure, scanray::CameraError::BadSize.into()] {
                assert!(!file.explain(error).to_string().is_empty());
            }
        }
    }
}

/// Lists the scenes of the gallery that are read quickly: one large mesh takes as long as all others.
fn quick() -> impl Iterator<Item = Entry> {
    scenes::all().filter(|entry| entry.name() != "knot")
}

/// Is where the files of the gallery lie.
static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("scene_file_random");
    std::fs::create_dir_all(&folder).unwrap();
    for entry in quick() {
        export(&entry, &folder, entry.name());
    }
    folder
});

fn a_scene() -> impl Strategy<Value = Vec<u8>> {
    let described = quick().map(|entry| describe(entry.double).unwrap());
    let texts: Vec<String> = described.map(|description| write(&description).unwrap()).collect();
    prop::sample::select(texts).prop_map(String::into_bytes)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn a_changed_file_is_read_or_refused(
        mut bytes in a_scene(),
        changes in prop::collection::vec(change(), 1..6),
    ) {
        for change in &changes {
            apply(&mut bytes, change);
        }
        use_as_file(bytes);
    }

    #[test]
    fn noise_is_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        use_as_file(bytes);
    }

    #[test]
    fn words_in_any_order_are_read_or_refused(
        words in prop::collection::vec(prop::sample::select(&WORDS[..]), 0..60),
    ) {
        use_as_file(words.concat().into_bytes());
    }
}

#[test]
fn brackets_and_comments_nested_deeply_do_not_exhaust_the_stack() {
    for open in ["(", "[", "{", "{\"a\":", "/*", "Some(", "objects: [", "(objects: [(shape: Sphere(center: "]
    {
        use_as_file(open.repeat(100_000).into_bytes());
        use_as_file(format!("(objects: [{}", open.repeat(100_000)).into_bytes());
    }
}
