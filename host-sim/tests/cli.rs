//! The command line as a user meets it: the built program, its files, its answers.

use host_sim::panel::Panel;
use host_sim::picture;
use scanray::gallery::{Gallery, fixed, float};
use scanray::{AtEdges, Dither, Jittered, Settings, Uniform};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Is a directory of a test's own that goes with it.
struct Desk(PathBuf);

impl Desk {
    fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("scanray-cli-{test}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn run(&self, arguments: &str) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_scanray"));
        command.args(arguments.split_whitespace()).current_dir(&self.0).env_remove("DISPLAY");
        command.output().unwrap()
    }

    fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

impl Drop for Desk {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn read(path: &Path) -> (Vec<[u8; 3]>, [u32; 2]) {
    let picture = image::open(path).unwrap().into_rgb8();
    (picture.pixels().map(|pixel| pixel.0).collect(), [picture.width(), picture.height()])
}

/// Demands exit code 2, nothing on stdout, and an error that says all this.
fn assert_refused(desk: &Desk, arguments: &str, says: &[&str]) {
    let output = desk.run(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments}: {output:?}");
    assert_eq!(stdout(&output), "", "{arguments}");
    for word in says {
        assert!(stderr(&output).contains(word), "{arguments} does not say {word:?}: {}", stderr(&output));
    }
    assert!(!stderr(&output).contains("panicked"), "{}", stderr(&output));
}

#[test]
fn without_arguments_it_draws_the_simple_scene_and_tells_what_it_did() {
    let desk = Desk::new("bare");
    let output = desk.run("");
    assert!(output.status.success(), "{output:?}");
    assert_eq!(desk.files(), ["simple.png"]);
    assert_eq!(read(&desk.0.join("simple.png")).1, [240, 240]);
    let text = stdout(&output);
    for word in ["57,600 primary", "shadow", "rays/s", "1804 bytes", "dB PSNR", "/255", "simple.png"] {
        assert!(text.contains(word), "no {word:?} in {text}");
    }
    assert!(!text.contains('\u{1b}'), "escapes in what is no terminal: {text}");
}

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

#[test]
fn an_alias_may_hand_on_a_second_separator() {
    let desk = Desk::new("separator");
    let output = desk.run("-- render simple --size 8x8");
    assert!(output.status.success(), "{output:?}");
    assert_eq!(desk.files(), ["simple.png"]);
}

#[test]
fn no_window_opens_and_no_file_appears_elsewhere_when_nobody_sits_at_a_terminal() {
    let desk = Desk::new("unattended");
    let mut command = Command::new(env!("CARGO_BIN_EXE_scanray"));
    // A display that does not exist would make an attempt show in the output.
    let output = command
        .args(["render", "--size", "8x8"])
        .current_dir(&desk.0)
        .env("DISPLAY", ":9999")
        .output()
        .unwrap();
    assert!(output.status.success(), "{output:?}");
    assert!(!stdout(&output).contains("window"), "{}", stdout(&output));
    assert_eq!(stderr(&output), "");
}

#[test]
fn the_list_names_every_scene_with_its_size_and_what_it_shows() {
    let output = Desk::new("list").run("list");
    let text = stdout(&output);
    for (view, line) in f32::views().iter().zip(text.lines()) {
        let [columns, rows] = view.size;
        assert!(line.starts_with(view.name) && line.contains(&format!("{columns}x{rows}")), "{line}");
        assert!(line.ends_with(view.about), "{line}");
    }
    assert_eq!(text.lines().count(), f32::views().len());
}

#[test]
fn an_exported_scene_draws_the_picture_of_the_gallery() {
    let desk = Desk::new("export");
    let output = desk.run("export c-ray -o mine.ron");
    assert!(output.status.success(), "{output:?}");
    for number in ["f32", "fixed"] {
        for scene in ["c-ray", "mine.ron"] {
            let output = desk.run(&format!("render {scene} --number {number} --size 64x48"));
            assert!(output.status.success(), "{output:?}");
        }
        let [gallery, file] = ["c-ray.png", "mine.png"].map(|name| read(&desk.0.join(name)));
        assert!(gallery == file, "{number}");
    }
}

#[test]
fn a_scene_file_is_taken_wherever_a_scene_is() {
    let desk = Desk::new("file");
    assert!(desk.run("export simple").status.success());
    assert_eq!(desk.files(), ["simple.ron"]);
    let list = stdout(&desk.run("list simple.ron"));
    assert!(list.starts_with("simple  240x240  a ball, a floor") && list.lines().count() == 1, "{list}");
    let output = desk.run("compare simple.ron --size 24x18 --json");
    assert!(stdout(&output).contains("\"scene\": \"simple\""), "{output:?}");
    let again = desk.run("export simple.ron -o -");
    assert_eq!(stdout(&again), std::fs::read_to_string(desk.0.join("simple.ron")).unwrap());
    assert_refused(&desk, "show simple.ron", &["no display"]);
}

#[test]
fn mistakes_of_a_scene_file_are_shown_with_their_line() {
    let desk = Desk::new("mistakes");
    assert!(desk.run("export simple").status.success());
    let text = std::fs::read_to_string(desk.0.join("simple.ron")).unwrap();
    std::fs::write(desk.0.join("field.ron"), text.replace("radius", "raduis")).unwrap();
    std::fs::write(desk.0.join("large.ron"), text.replace("radius: 25", "radius: 2500")).unwrap();
    let line = [":28:", "(shape: Sphere", "^^^^^^"];
    let says =
        ["error: unknown field `raduis`, did you mean `radius`?", "field.ron", line[0], line[1], line[2]];
    assert_refused(&desk, "render field.ron", &says);
    let says = ["error: object 0: ", "too large for the number type", "large.ron", line[0], line[1], line[2]];
    assert_refused(&desk, "render large.ron --number fixed", &says);
    assert_refused(&desk, "compare large.ron --number fixed", &says);
    assert_refused(&desk, "render none.ron", &["cannot read none.ron"]);
    assert_refused(&desk, "export simple -o no/such/place.ron", &["no/such/place.ron", "-o"]);
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let mut command = Command::new(env!("CARGO_BIN_EXE_scanray"));
    let child = command.arg("list").stdout(writer).stderr(std::process::Stdio::piped()).spawn().unwrap();
    drop(command);
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{output:?}");
    assert_eq!(stderr(&output), "");
}

#[test]
fn wrong_words_are_refused_with_a_way_out() {
    let desk = Desk::new("wrong");
    assert_refused(&desk, "render simpel", &["no scene 'simpel'", "did you mean 'simple'", "scanray list"]);
    assert_refused(&desk, "render --size 240", &["320x240"]);
    assert_refused(&desk, "render --size 0x5", &["320x240"]);
    assert_refused(&desk, "render --size 99999x5", &["4096", "320x240"]);
    assert_refused(&desk, "render --depth 33", &["from 0 to 32"]);
    assert_refused(&desk, "render --step 3", &["3/72"]);
    assert_refused(&desk, "render --panel rgb555", &["rgb565"]);
    assert_refused(&desk, "render --dither floyd", &["blue-noise", "diffused"]);
    assert_refused(&desk, "render --samples 9", &["from 1 to 8"]);
    assert_refused(&desk, "render --samples 0", &["from 1 to 8"]);
    assert_refused(&desk, "render --jitter", &["--samples"]);
    assert_refused(&desk, "render --samples 2 --quality adaptive", &["--quality"]);
    assert_refused(&desk, "progressive --quality adaptive", &["step by step"]);
    assert_refused(&desk, "progressive --number oracle", &["step by step"]);
    assert_refused(&desk, "progressive --size 8x8 -o no/such/place.gif", &["no/such/place.gif", "-o"]);
    assert_refused(&desk, "compare", &["no scene to compare", "--all"]);
    assert_refused(&desk, "compare simple --number oracle", &["f32, fixed and exact"]);
    assert_refused(&desk, "draw", &["draw", "--help"]);
    assert_eq!(desk.files(), [""; 0]);
}

#[test]
fn what_cannot_be_written_is_said_with_its_place() {
    let desk = Desk::new("unwritable");
    assert_refused(&desk, "render --size 8x8 -o no/such/place.png", &["no/such/place.png", "-o"]);
    assert_refused(&desk, "render --size 8x8 -o .", &["cannot write .", "-o"]);
    std::fs::write(desk.0.join("taken"), "").unwrap();
    assert_refused(&desk, "compare simple --size 8x8 -o taken", &["taken", "-o"]);
}

#[test]
fn a_window_without_a_display_is_refused_with_a_way_out() {
    assert_refused(&Desk::new("blind"), "show simple", &["no display", "scanray render"]);
}

#[test]
fn help_is_no_error_and_gives_examples() {
    let desk = Desk::new("help");
    for command in ["", "render", "show", "progressive", "compare", "dither", "list", "export"] {
        let arguments = format!("{command} --help");
        let output = desk.run(&arguments);
        assert!(output.status.success(), "{arguments}");
        assert!(stdout(&output).contains("Examples:"), "{arguments}");
    }
}
