//! Whatever an OBJ file, its library or an image holds, it is read or refused, soon.

use crate::model_files::{LIBRARY, vase};
use host_sim::obj::{self, Mistake, Reason};
use host_sim::scene_file::png_file;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::io::Cursor;
use std::path::Path;
use std::time::{Duration, Instant};

/// Is what may stand where it should not.
const WORDS: [&str; 32] = [
    "v",
    "vt",
    "vn",
    "f",
    "usemtl",
    "mtllib vase.mtl",
    "newmtl",
    "Kd",
    "map_Kd",
    "illum",
    "\\\n",
    "\n",
    "\r",
    "#",
    "/",
    "//",
    "-",
    "0",
    "-1",
    "4294967296",
    "9223372036854775808",
    "-9223372036854775808",
    "1e999",
    "-1e999",
    "NaN",
    "inf",
    "1e-320",
    "-0",
    "1e12",
    "\u{feff}",
    "\u{0}",
    "é",
];

/// Is a change that somebody, or a broken disk, makes to a file.
#[derive(Clone, Debug)]
enum Change {
    /// A piece left out.
    Cut(Index, usize),
    /// A piece put in a second time, somewhere else.
    Paste(Index, usize, Index),
    /// A number, or another word, in the place of one.
    Swap(Index, &'static str),
    /// A word put in, so often.
    Repeat(Index, &'static str, usize),
    /// Another byte in the place of one.
    Byte(Index, u8),
}

fn change() -> impl Strategy<Value = Change> {
    let (place, word) = (any::<Index>, || select(&WORDS[..]));
    prop_oneof![
        (place(), 1_usize..200).prop_map(|(at, length)| Change::Cut(at, length)),
        (place(), 1_usize..200, place()).prop_map(|(from, length, to)| Change::Paste(from, length, to)),
        (place(), word()).prop_map(|(at, word)| Change::Swap(at, word)),
        (place(), word(), select(&[1_usize, 1, 1, 2, 5000][..]))
            .prop_map(|(at, word, times)| Change::Repeat(at, word, times)),
        (place(), any::<u8>()).prop_map(|(at, byte)| Change::Byte(at, byte)),
    ]
}

fn apply(bytes: &mut Vec<u8>, change: &Change) {
    if bytes.is_empty() {
        return;
    }
    let length = bytes.len();
    let piece = |at: &Index, size: usize| at.index(length)..length.min(at.index(length) + size);
    match change {
        Change::Cut(at, size) => drop(bytes.drain(piece(at, *size))),
        Change::Paste(from, size, to) => {
            let copy = bytes[piece(from, *size)].to_vec();
            let to = to.index(length);
            bytes.splice(to..to, copy);
        }
        Change::Swap(at, word) => {
            let begin = at.index(length);
            let is_word = |byte: &u8| !byte.is_ascii_whitespace() && *byte != b'/';
            let end = begin + bytes[begin..].iter().take_while(|byte| is_word(byte)).count();
            bytes.splice(begin..end, word.bytes());
        }
        Change::Repeat(at, word, times) => {
            let at = at.index(length);
            bytes.splice(at..at, [word, " "].concat().repeat(*times).into_bytes());
        }
        Change::Byte(at, byte) => bytes[at.index(length)] = *byte,
    }
}

fn read(model: &str, library: &str) -> Result<usize, Mistake> {
    obj::parse(Path::new("/nowhere/vase.obj"), model, &mut |_| Ok(library.to_owned()))
        .map(|model| model.count())
}

/// Reads bytes as a model and its library: a complaint names the line.
fn use_as_files(model: &[u8], library: &[u8]) {
    let [model, library] = [model, library].map(String::from_utf8_lossy);
    if let Err(mistake) = read(&model, &library) {
        let of_whole = matches!(mistake.reason, Reason::Reader(_) | Reason::Io(_));
        assert!(of_whole || mistake.line.is_some(), "{mistake}");
    }
}

/// Is the library without the image, which lies nowhere.
fn plain_library() -> String {
    LIBRARY.replace("map_Kd cloth.png", "")
}

/// Answers a small image as a file.
fn image_file() -> Vec<u8> {
    let mut file = Cursor::new(vec![]);
    let image = image::RgbImage::from_fn(7, 5, |x, y| image::Rgb([x as u8, y as u8, 9]));
    image.write_to(&mut file, image::ImageFormat::Png).expect("it fits");
    file.into_inner()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn a_changed_model_is_read_or_refused(
        of_model in vec(change(), 0..5),
        of_library in vec(change(), 0..5),
    ) {
        let (mut model, mut library) = (vase().into_bytes(), plain_library().into_bytes());
        of_model.iter().for_each(|change| apply(&mut model, change));
        of_library.iter().for_each(|change| apply(&mut library, change));
        use_as_files(&model, &library);
    }

    #[test]
    fn words_of_models_in_any_order_are_read_or_refused(
        model in vec(select(&WORDS[..]), 0..60),
        library in vec(select(&WORDS[..]), 0..60),
    ) {
        use_as_files(model.join(" ").as_bytes(), library.join(" ").as_bytes());
    }

    #[test]
    fn a_changed_image_is_decoded_or_refused(changes in vec(change(), 0..5)) {
        let mut bytes = image_file();
        changes.iter().for_each(|change| apply(&mut bytes, change));
        if let Ok(bitmap) = png_file::decode(Cursor::new(bytes), 64) {
            prop_assert!(bitmap.fits());
        }
    }
}

#[test]
fn models_that_ask_for_much_are_soon_refused_or_read() {
    let many = |line: &dyn Fn(usize) -> String, count| (0..count).map(line).collect::<String>();
    let names = many(&|i| format!("newmtl {i}\n"), 60_000);
    let uses = many(&|i| format!("usemtl {i}\nf 1 2 3\n"), 60_000);
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let endless = "x".repeat(1 << 20);
    let cases = [
        (format!("mtllib a\n{corners}{uses}"), names.clone(), true),
        (format!("mtllib a\n{corners}usemtl {endless}\nf 1 2 3"), format!("newmtl {endless}y"), false),
        (many(&|i| format!("mtllib {i}\n"), 200), names, false),
        ("mtllib a\n".to_owned(), "newmtl a\n".repeat(100_000), false),
        (format!("{corners}f {}", "1 2 3 ".repeat(100_000)), String::new(), false),
        ("\\\n".repeat(1 << 19), String::new(), true),
    ];
    for (place, (model, library, is_good)) in cases.iter().enumerate() {
        let start = Instant::now();
        let read = read(model, library);
        assert_eq!(read.is_ok(), *is_good, "{place}: {:?}", read.map_err(|mistake| mistake.line));
        assert!(start.elapsed() < Duration::from_secs(20), "{place}: {:?}", start.elapsed());
    }
}
