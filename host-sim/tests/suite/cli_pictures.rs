//! The pictures that the command line draws are those of the library.

use crate::desk::{Desk, read, stdout};
use host_sim::panel::Panel;
use host_sim::picture;
use scanray::gallery::{fixed, float};
use scanray::{AtEdges, Dither, Jittered, Settings, Uniform};
use std::path::Path;

#[test]
fn the_file_holds_the_picture_the_library_makes() {
    let desk = Desk::new("pixels");
    let output = desk.run("render c-ray --size 40x30 --panel gray4 --depth 2 -o small.png");
    assert!(output.status.success(), "{output:?}");
    let view = float::C_RAY;
    let film = picture::trace(&view, view.settings.with_depth(2), [40, 30], |_| ()).unwrap();
    let expected = film.on_panel(Panel::Gray4, view.settings.transfer, Dither::Ordered);
    assert_eq!(read(&desk.0.join("small.png")), (expected, [40, 30]));
}

#[test]
fn number_panel_depth_transfer_and_dithering_each_change_the_picture() {
    let desk = Desk::new("options");
    let changes = [
        "",
        "--number fixed",
        "--panel rgb888",
        "--depth 1",
        "--transfer srgb",
        "--number oracle",
        "--dither none",
        "--dither blue-noise",
        "--dither diffused",
    ];
    let pictures = changes.map(|change| {
        // On 240 x 180 pixels the numbers' roundings show in some of them.
        let output = desk.run(&format!("render business-card --size 240x180 {change} -o x.png"));
        assert!(output.status.success(), "{change}: {output:?}");
        read(&desk.0.join("x.png")).0
    });
    for (picture, change) in pictures.iter().zip(changes).skip(1) {
        assert!(*picture != pictures[0], "{change} changes nothing");
    }
}

#[test]
fn a_step_carries_the_camera_around_and_the_last_is_the_first() {
    let desk = Desk::new("step");
    let [first, second, last] = ["0/7", "1/7", "7/7"].map(|step| {
        let output = desk.run(&format!("render simple --number fixed --size 48x32 --step {step} -o x.png"));
        assert!(output.status.success(), "{step}: {output:?}");
        read(&desk.0.join("x.png")).0
    });
    assert!(first == last && first != second);
    let mut view = fixed::SIMPLE;
    view.camera = view.camera.turned(1, 7);
    let film = picture::trace(&view, view.settings, [48, 32], |_| ()).unwrap();
    assert!(film.on_panel(Panel::Rgb565, view.settings.transfer, Dither::Ordered) == second);
}

#[test]
fn a_sheet_shows_three_panels_in_every_way_and_a_table_says_what_each_is_worth() {
    let desk = Desk::new("sheet");
    let output = desk.run("dither simple --size 32x24");
    assert!(output.status.success(), "{output:?}");
    assert_eq!(desk.files(), ["simple-dither.png"]);
    assert_eq!(read(&desk.0.join("simple-dither.png")).1, [4 * (32 + 4) + 4, 3 * (24 + 14) + 4]);
    let text = stdout(&output);
    for panel in ["mono", "gray4", "rgb565"] {
        let rows =
            text.lines().filter(|line| line.starts_with(panel)).map(|line| line.split_whitespace().nth(1));
        assert!(rows.flatten().eq(["none", "ordered", "blue-noise", "diffused"]), "{text}");
    }
}

#[test]
fn the_sheet_among_the_pictures_is_what_the_command_draws() {
    let desk = Desk::new("sheet-kept");
    assert!(desk.run("dither three-spheres --size 160x120 -o sheet.png").status.success());
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("../pictures/dither.png");
    let same = read(&kept) == read(&desk.0.join("sheet.png"));
    assert!(same, "look at it, then `cargo sim dither three-spheres --size 160x120 -o pictures/dither.png`");
}

#[test]
fn several_rays_a_pixel_are_those_of_the_library() {
    let desk = Desk::new("samples");
    let view = float::C_RAY;
    let expected =
        |film: picture::Film<f32>| film.on_panel(Panel::Rgb565, view.settings.transfer, Dither::Ordered);
    let drawn = |options: &str| {
        let output = desk.run(&format!("render c-ray --size 40x30 {options} -o x.png"));
        assert!(output.status.success(), "{options}: {output:?}");
        (read(&desk.0.join("x.png")).0, stdout(&output))
    };
    let film = |settings: Settings<f32, _>| picture::trace(&view, settings, [40, 30], |_| ()).unwrap();
    let (picture, text) = drawn("--samples 2");
    assert!(picture == expected(film(view.settings.with_quality(Uniform(2)))));
    assert!(text.contains("4,800 primary") && text.contains("2x2 rays a pixel"), "{text}");
    let (scattered, text) = drawn("--samples 2 --jitter");
    let film = picture::trace(&view, view.settings.with_quality(Jittered(2)), [40, 30], |_| ()).unwrap();
    assert!(scattered == expected(film));
    assert!(text.contains("2x2 scattered rays a pixel"), "{text}");
    let (at_edges, text) = drawn("--samples 2 --jitter --adaptive-samples");
    let settings = view.settings.with_quality(AtEdges(Jittered(2)));
    assert!(at_edges == expected(picture::trace(&view, settings, [40, 30], |_| ()).unwrap()));
    assert!(text.contains("rays a pixel on an edge"), "{text}");
}

#[test]
fn the_animation_of_a_progressive_picture_ends_with_that_picture() {
    let desk = Desk::new("progressive");
    let output = desk.run("progressive simple --size 40x30 --panel mono --block 8");
    assert!(output.status.success(), "{output:?}");
    for word in ["blocks 8", "blocks 4", "blocks 2", "blocks 1", "100.0%", "simple.gif"] {
        assert!(stdout(&output).contains(word), "no {word:?} in {}", stdout(&output));
    }
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut animation = options.read_info(std::fs::File::open(desk.0.join("simple.gif")).unwrap()).unwrap();
    assert_eq!([animation.width(), animation.height()], [40, 30]);
    // Frames are laid over what is shown already.
    let (mut shown, mut frames) = (vec![[0_u8; 4]; 40 * 30], 0);
    while let Some(frame) = animation.read_next_frame().unwrap() {
        assert_eq!([frame.left, frame.width], [0, 40]);
        assert!(frames > 0 || frame.height == 30, "the first pass is shown whole");
        let (pixels, _) = frame.buffer.as_chunks::<4>();
        shown[usize::from(frame.top) * 40..][..pixels.len()].copy_from_slice(pixels);
        frames += 1;
    }
    assert!(frames >= 4, "{frames}");
    let view = float::SIMPLE;
    let film = picture::trace(&view, view.settings, [40, 30], |_| ()).unwrap();
    let picture = film.on_panel(Panel::Mono, view.settings.transfer, Dither::Ordered);
    assert!(shown.iter().map(|[r, g, b, _]| [*r, *g, *b]).eq(picture));
}
