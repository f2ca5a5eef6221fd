//! How much memory a hostile file can ask for: a multiple of its length, and no more.
//!
//! A program of its own: it counts all that is allocated, and nothing may run beside it.

use host_sim::obj;
use host_sim::scene_file::{SceneFile, png_file};
use peak_alloc::PeakAlloc;
use std::io::Cursor;
use std::path::Path;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Is how many bytes a byte of a text may take: `f 1 1 1 1 ...` is a triangle of 240 bytes for every two, and the
/// list of them is twice as long while it grows.
const A_BYTE: usize = 200;

/// Is what any file may take beside.
const ANY: usize = 1 << 20;

/// Is what an image may take, however short its file is: 2048 x 2048 texels twice.
const IMAGE: usize = 2 * 3 * 2048 * 2048 + ANY;

/// Answers by how many bytes memory grew at most while something was done.
fn peak(work: impl FnOnce()) -> usize {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    work();
    MEMORY.peak_usage().saturating_sub(before)
}

#[track_caller]
fn assert_takes(what: &str, length: usize, most: usize, work: impl FnOnce()) {
    let peak = peak(work);
    println!("{what}: {length} bytes take {peak}, {:.1} each", peak as f64 / length as f64);
    assert!(peak <= most, "{what}: {length} bytes take {peak}, more than {most}");
}

fn assert_text(name: &str, text: &str) {
    let most = A_BYTE * text.len() + ANY;
    assert_takes(name, text.len(), most, || match name {
        "x.obj" => drop(obj::parse(Path::new("/nowhere/x.obj"), text, &mut |_| Ok(text.to_owned()))),
        _ => drop(SceneFile::parse(&Path::new("/nowhere").join(name), text.as_bytes().to_vec())),
    });
}

/// Answers the beginning of a PNG that says it has so many columns and rows.
fn png_header(size: u32) -> Vec<u8> {
    let mut image = Cursor::new(vec![]);
    let one = image::GrayImage::new(1, 1);
    one.write_to(&mut image, image::ImageFormat::Png).expect("it fits");
    let mut bytes = image.into_inner();
    bytes[16..20].copy_from_slice(&size.to_be_bytes());
    bytes[20..24].copy_from_slice(&size.to_be_bytes());
    let sum = crc32(&bytes[12..29]);
    bytes[29..33].copy_from_slice(&sum.to_be_bytes());
    bytes
}

/// Is the check sum of a PNG's pieces (ISO 3309).
fn crc32(bytes: &[u8]) -> u32 {
    let shifted = |sum: u32, _| if sum & 1 == 1 { sum >> 1 ^ 0xedb8_8320 } else { sum >> 1 };
    !bytes.iter().fold(!0, |sum, byte| (0..8).fold(sum ^ u32::from(*byte), shifted))
}

#[test]
fn no_file_takes_more_memory_than_a_multiple_of_its_length() {
    let nff =
        "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 512 512\nf 1 1 1 1 0 0 0 0\n";
    for text in [
        format!("{nff}p 4294967295\n0 0 0\n"),
        format!("{nff}pp 99999999999999\n0 0 0 0 0 1\n"),
        format!("{nff}{}", "s 0 0 0 1\n".repeat(5000)),
        format!("{nff}p 20000\n{}", "0 0 0 1 0 0 ".repeat(10_000)),
        nff.replace("512 512", "4294967295 4294967295"),
    ] {
        assert_text("x.nff", &text);
    }
    for text in [
        "(".repeat(100_000),
        "(objects: [".to_owned()
            + &"(shape: Sphere(center: (0, 0, 0), radius: 1), material: \"a\"),".repeat(2000),
        "(materials: {".to_owned() + &"\"a\": (),".repeat(20_000),
        "[".repeat(50_000) + &"]".repeat(50_000),
        "\"".to_owned() + &"\\u{41}".repeat(50_000),
        "/*".repeat(50_000),
    ] {
        assert_text("x.ron", &text);
    }
    for text in [
        format!("v 0 0 0\nf {}", "1 ".repeat(100_000)),
        "v 0 0 0\nf 1 1 1\n".repeat(10_000),
        "v 0 0 0\nf 4294967295 -9223372036854775808 1\n".to_owned(),
        "newmtl a\n".repeat(20_000),
        (0..10_000)
            .fold("mtllib a\nv 0 0 0\n".to_owned(), |text, i| text + &format!("usemtl {i}\nf 1 1 1\n")),
        "\\\n".repeat(100_000),
    ] {
        assert_text("x.obj", &text);
    }
    for size in [1, 100, 2048, 2049, 65_535, u32::MAX] {
        let bytes = png_header(size);
        assert_takes("x.png", bytes.len(), IMAGE, || drop(png_file::decode(Cursor::new(bytes), u32::MAX)));
    }
}
