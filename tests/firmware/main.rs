//! Firmware on emulated boards: what the panel shows is, byte for byte, what the host computes.
//!
//! Each test builds an example for its board, starts it as a user would, and compares the picture read back. What the
//! images cost goes to standard output and, as a table, to `target/boards.md`.

mod board;
mod dealing;
#[path = "../../examples/boards/models.rs"]
mod models;
#[path = "../../examples/boards/one_core.rs"]
mod one_core;
mod passes;
mod table;
#[path = "../../examples/boards/turntable.rs"]
mod turntable;
#[path = "../../examples/boards/two_cores.rs"]
mod two_cores;
#[path = "../../examples/boards/wire.rs"]
mod wire;

use std::fmt::Debug;

use board::{Board, Run};
use embedded_graphics::{geometry::Size, pixelcolor::Gray4, prelude::*};
use scanray::{
    Fixed, Renderer, Scalar, Workspace,
    gallery::{self, Gallery, View},
    output::Encode,
};

const RP2040: Board = Board { example: "rp2040_st7789", target: "thumbv6m-none-eabi" };
const SPIN: Board = Board { example: "rp2040_spin", target: "thumbv6m-none-eabi" };
const TWO_CORES: Board = Board { example: "rp2040_two_cores", target: "thumbv6m-none-eabi" };
const PROGRESSIVE: Board = Board { example: "rp2040_progressive", target: "thumbv6m-none-eabi" };
const MODELS: Board = Board { example: "rp2040_models", target: "thumbv6m-none-eabi" };
const LM3S6965: Board = Board { example: "lm3s6965_oled", target: "thumbv7m-none-eabi" };
const MPS2: Board = Board { example: "mps2_bench", target: "thumbv7em-none-eabihf" };

#[test]
#[ignore = "needs node with rp2040js (run by .ci/run)"]
fn the_st7789_on_an_rp2040_shows_what_the_host_computes() {
    let run = Run::of(&RP2040);
    let host = picture::<Fixed, [u8; 2]>("simple", 240, 240);
    assert_same(&run.picture("rp2040_st7789.rgb565"), host.as_flattened(), 2 * 240);
    assert_transfer_hides_behind_tracing(&run);
    table::add(&run, "simple, 240x240", "instructions");
    table::print_times(&run);
}

#[test]
#[ignore = "needs node with rp2040js (run by .ci/run)"]
fn a_turning_rp2040_shows_the_steps_that_the_host_computes() {
    let run = Run::of_frames(&SPIN, 2);
    let [first, second] = turning_pictures(&run);
    assert!(first != second, "the camera does not turn");
    assert_transfer_hides_behind_tracing(&run);
    table::add(&run, "three-spheres, 240x240, turning", "instructions");
    table::print_times(&run);
}

#[test]
#[ignore = "needs node with rp2040js (run by .ci/run)"]
fn two_cores_of_an_rp2040_show_what_the_host_computes_in_half_the_time() {
    let run = Run::of_frames(&TWO_CORES, 2);
    turning_pictures(&run);
    // The lamp shows what the first core does: half of the rows. The rest of the frame is waiting.
    let (tracing, frame) = (run.count("tracing"), run.count("frame"));
    assert!(frame < tracing + tracing / 20, "{frame} cycles, of which the first core traces {tracing}");
    table::add(&run, "three-spheres, 240x240, turning, first core", "instructions");
    table::print_times(&run);
}

#[test]
#[ignore = "needs node with rp2040js (run by .ci/run)"]
fn an_rp2040_shows_every_other_pass_as_the_host_and_ends_with_the_direct_picture() {
    // A panel full of pixels is written by the first pass, and by every two of the others.
    let run = Run::of_frames(&PROGRESSIVE, 3);
    let shown = [0, 1, 2].map(|frame| run.picture(&format!("rp2040_progressive-{frame}.rgb565")));
    let host = passes::of::<240>(&gallery::fixed::THREE_SPHERES);
    for (shown, side) in shown.iter().zip([16, 4, 1]) {
        let (_, pass) = host.iter().find(|(pass, _)| *pass == side).expect("a pass of that side");
        assert_same(shown, pass, 2 * 240);
    }
    assert_same(&shown[2], picture::<Fixed, [u8; 2]>("three-spheres", 240, 240).as_flattened(), 2 * 240);
    table::add(&run, "three-spheres, 240x240, progressive", "instructions");
}

#[test]
#[ignore = "needs node with rp2040js (run by .ci/run)"]
fn an_rp2040_shows_models_of_many_triangles_out_of_2_mb_of_flash_and_8_kb_of_ram() {
    let run = Run::of_frames(&MODELS, models::VIEWS.len());
    for (number, view) in models::VIEWS.iter().enumerate() {
        let shown = run.picture(&format!("rp2040_models-{number}.rgb565"));
        let host = picture_of::<Fixed, [u8; 2]>(view, 240, 240);
        assert_same(&shown, host.as_flattened(), 2 * 240);
    }
    let [flash, ram] = table::memory(&run);
    assert!(flash <= 2 << 20, "{flash} bytes of flash");
    assert!(ram <= 8 << 10, "{ram} bytes of RAM, the stack included");
    table::add(&run, "teapot, knot and balls2, 240x240", "instructions");
}

/// How often is up to `SCANRAY_RESETS`.
#[test]
#[ignore = "needs node with rp2040js (run by .ci/run)"]
fn an_rp2040_that_is_reset_at_any_moment_draws_the_whole_picture_afterwards() {
    let resets = from_environment("SCANRAY_RESETS").unwrap_or(2);
    let run = Run::of_resets(&RP2040, resets);
    let host = picture::<Fixed, [u8; 2]>("simple", 240, 240);
    for number in 0..resets {
        let shown = run.picture(&format!("rp2040_st7789-reset-{number}.rgb565"));
        assert_same(&shown, host.as_flattened(), 2 * 240);
    }
}

/// Runs for `SCANRAY_SOAK_SECONDS` of the board's own time; a turn takes 134 of them.
#[test]
#[ignore = "runs for as long as SCANRAY_SOAK_SECONDS says, and needs node with rp2040js"]
fn an_rp2040_that_turns_for_long_shows_the_same_pictures_again() {
    let Some(seconds) = from_environment("SCANRAY_SOAK_SECONDS") else {
        return println!("SCANRAY_SOAK_SECONDS does not say for how long: nothing is run");
    };
    let run = Run::of_seconds(&SPIN, seconds);
    let steps = usize::from(turntable::STEPS);
    let host: Vec<_> = turntable::cameras()
        .take(steps)
        .map(|camera| picture_of::<Fixed, [u8; 2]>(&View { camera, ..*turntable::VIEW }, 240, 240))
        .collect();
    let frames = run.count("frames") as usize;
    for (frame, host) in (0..frames).zip(host.iter().cycle()) {
        let shown = run.picture(&format!("rp2040_spin-{frame}.rgb565"));
        assert_same(&shown, host.as_flattened(), 2 * 240);
    }
    println!("{frames} pictures, {} whole turns, as the host computes them", frames / steps);
}

fn from_environment(name: &str) -> Option<usize> {
    let value = std::env::var(name).ok()?;
    Some(value.parse().unwrap_or_else(|_| panic!("{name} is no number: {value}")))
}

/// Answers the first two pictures of a turning board, which are the host's.
fn turning_pictures(run: &Run) -> [Vec<u8>; 2] {
    let mut cameras = turntable::cameras();
    [0, 1].map(|step| {
        let view = View { camera: cameras.next().expect("it turns for good"), ..*turntable::VIEW };
        let host = picture_of::<Fixed, [u8; 2]>(&view, 240, 240);
        let shown = run.picture(&format!("{}-{step}.rgb565", run.board.example));
        assert_same(&shown, host.as_flattened(), 2 * 240);
        shown
    })
}

/// Asserts that a frame takes longer than either of its parts, but hardly longer than the longer one.
fn assert_transfer_hides_behind_tracing(run: &Run) {
    let [tracing, transfer, frame] = ["tracing", "transfer", "frame"].map(|key| run.count(key));
    let times = format!("tracing {tracing}, transfer {transfer}, side by side {frame} cycles");
    // Two bytes a pixel at half the core's clock are 32 cycles; the commands between frames are a few more.
    let pixels = 32 * 240 * 240;
    assert!((pixels..pixels + 1000).contains(&transfer), "{times}");
    let longer = tracing.max(transfer);
    assert!((longer..longer + tracing.min(transfer) / 10).contains(&frame), "{times}");
}

#[test]
#[ignore = "needs node and qemu-system-arm (run by .ci/run)"]
fn the_oled_of_an_lm3s6965_shows_what_the_host_computes() {
    let run = Run::of(&LM3S6965);
    let host: Vec<u8> = picture::<Fixed, Gray4>("simple", 128, 64).iter().map(|grey| grey.luma()).collect();
    assert_same(&run.picture("lm3s6965_oled.gray4"), &host, 128);
    table::add(&run, "simple, 128x64", "instructions");
}

#[test]
#[ignore = "needs node and qemu-system-arm (run by .ci/run)"]
fn a_cortex_m4f_renders_what_the_host_computes() {
    let run = Run::of(&MPS2);
    for scene in ["three-spheres", "simple"] {
        let host = picture::<f32, [u8; 2]>(scene, 320, 240);
        assert_same(&run.picture(&format!("{scene}.rgb565")), host.as_flattened(), 2 * 320);
        table::add(&run, &format!("{scene}, 320x240"), &format!("{scene}.instructions"));
    }
}

/// A loop in place of `main` stands for every way a chip can hang: the board must say so, and where.
#[test]
#[ignore = "needs node with rp2040js (run by .ci/run)"]
fn firmware_that_hangs_is_reported() {
    let said = board::run_with_main_replaced(&RP2040, [0xfe, 0xe7]);
    assert!(said.contains("the firmware stopped in"), "{said}");
}

/// An undefined instruction in place of `main` stands for every fault.
#[test]
#[ignore = "needs node and qemu-system-arm (run by .ci/run)"]
fn firmware_that_faults_is_reported() {
    for chip in [&LM3S6965, &MPS2] {
        let said = board::run_with_main_replaced(chip, [0x00, 0xde]);
        assert!(said.contains("failed: the processor faulted"), "{said}");
    }
}

/// The comparison above must be able to fail.
#[test]
#[should_panic(expected = "byte 1 of row 2 is 9, the host computes 8")]
fn one_wrong_byte_is_found() {
    assert_same(&[1, 2, 3, 4, 5, 9], &[1, 2, 3, 4, 5, 8], 2);
}

/// The picture of a gallery scene, as the core renders it here.
fn picture<S: Gallery, C: Encode>(scene: &str, width: u32, height: u32) -> Vec<C> {
    let view = S::find(scene).unwrap_or_else(|| panic!("the gallery has no scene '{scene}'"));
    picture_of(view, width, height)
}

/// The picture of a view, as the core renders it here.
fn picture_of<S: Scalar, C: Encode>(view: &View<S>, width: u32, height: u32) -> Vec<C> {
    let mut space = Workspace::<S, C, 0, 5>::new();
    let size = Size::new(width, height);
    let mut renderer =
        Renderer::new(&view.scene, &view.camera, size, view.settings, &mut space).unwrap_or_else(refused);
    let mut pixels = vec![C::DARKEST; (width * height) as usize];
    for (y, row) in (0..).zip(pixels.chunks_exact_mut(width as usize)) {
        renderer.render_row(y, row).unwrap_or_else(refused);
    }
    pixels
}

fn refused<T>(error: impl Debug) -> T {
    panic!("the host refuses what the board draws: {error:?}")
}

/// Asserts that the bytes of two pictures are the same, and names the first that is not.
fn assert_same(board: &[u8], host: &[u8], row_bytes: usize) {
    assert_eq!(board.len(), host.len(), "the pictures differ in size");
    let different = board.iter().zip(host).filter(|(a, b)| a != b).count();
    if let Some(at) = board.iter().zip(host).position(|(a, b)| a != b) {
        panic!(
            "{different} of {} bytes differ; byte {} of row {} is {}, the host computes {}",
            host.len(),
            at % row_bytes,
            at / row_bytes,
            board[at],
            host[at]
        );
    }
}
