//! Fresh projects on emulated boards: the panel shows, byte for byte, what the host computes of the same scene.

#[path = "../../templates/pico/src/scene.rs"]
mod scene;

use crate::built::image;
use embedded_graphics::{geometry::Size, pixelcolor::Gray4, prelude::*};
use host_sim::boards::find;
use scanray::{Fixed, Renderer, Workspace, output::Encode};
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

#[test]
#[ignore = "needs the target thumbv6m-none-eabi and node with rp2040js (run by .ci/run)"]
fn a_project_for_the_pico_shows_on_its_panel_what_the_host_computes() {
    assert_same(&shown("pico", "rgb565"), picture::<[u8; 2]>(240, 240).as_flattened());
}

#[test]
#[ignore = "needs the target thumbv6m-none-eabi and node with rp2040js (run by .ci/run)"]
fn rows_that_are_sent_by_dma_while_others_are_traced_are_those_that_the_host_computes() {
    assert_same(&shown("pico-embassy", "rgb565"), picture::<[u8; 2]>(240, 240).as_flattened());
}

#[test]
#[ignore = "needs the target thumbv7m-none-eabi, node and qemu-system-arm (run by .ci/run)"]
fn a_project_for_the_lm3s6965_shows_on_its_oled_what_the_host_computes() {
    let host: Vec<u8> = picture::<Gray4>(128, 64).iter().map(|grey| grey.luma()).collect();
    assert_same(&shown("lm3s6965evb", "gray4"), &host);
}

/// Answers what the panel of a fresh project's emulated board shows in the end, in the panel's format.
fn shown(board: &str, format: &str) -> Vec<u8> {
    let board = find(board).expect("a board");
    let image = image(board);
    let folder = TempDir::new().expect("there is no room for a folder");
    let output = Command::new(Path::new(env!("CARGO_MANIFEST_DIR")).join("boards/run"))
        .arg(board.emulator.expect("an emulated board"))
        .arg(&image)
        .env("SCANRAY_BOARD_OUT", folder.path())
        .output()
        .expect("the board's runner does not start");
    let said = [&output.stdout, &output.stderr].map(|said| String::from_utf8_lossy(said)).concat();
    assert!(output.status.success(), "{}:\n{said}", board.name);
    println!("{}: {said}", board.name);
    let name = image.file_name().expect("an image has a name").to_string_lossy();
    fs::read(folder.path().join(format!("{name}.{format}"))).expect("the run leaves a picture")
}

/// Answers the picture of the scene that fixed-point projects begin with.
fn picture<C: Encode>(width: u32, height: u32) -> Vec<C> {
    let mut space = Workspace::<Fixed, C, 0, 5>::new();
    let size = Size::new(width, height);
    let mut renderer = Renderer::new(&scene::SCENE, &scene::CAMERA, size, scene::SETTINGS, &mut space)
        .unwrap_or_else(|error| panic!("the host refuses the scene: {error}"));
    let mut pixels = vec![C::DARKEST; (width * height) as usize];
    for (y, row) in (0..).zip(pixels.chunks_exact_mut(width as usize)) {
        renderer.render_row(y, row).unwrap_or_else(|error| panic!("the host refuses row {y}: {error}"));
    }
    pixels
}

fn assert_same(board: &[u8], host: &[u8]) {
    assert_eq!(board.len(), host.len(), "the pictures differ in size");
    let different = board.iter().zip(host).filter(|(a, b)| a != b).count();
    assert_eq!(different, 0, "of {} bytes differ from the host's", host.len());
}

/// The comparison above must be able to fail.
#[test]
#[should_panic(expected = "of 3 bytes differ from the host's")]
fn one_wrong_byte_is_found() {
    assert_same(&[1, 2, 3], &[1, 9, 3]);
}
