//! Baked scenes compile as they are and draw the very pictures of the files that they were made of.

use crate::desk::{Desk, assert_refused, read, stdout};
use embedded_graphics_core::pixelcolor::raw::RawU16;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use host_sim::bake::source::Planted;
use host_sim::bake::{Accel, meshes};
use scanray::gallery::{self, Gallery};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Lists what is baked: the name of a module, the scene, the number and other options.
const BAKED: [[&str; 3]; 20] = [
    ["vase_f32", "vase.obj", "f32"],
    ["vase_fixed", "vase.obj", "fixed"],
    ["temple_f32", "temple.ron", "f32"],
    ["temple_fixed", "temple.ron", "fixed"],
    ["temple_tree", "temple.ron", "fixed --accel bvh"],
    ["planets_fixed", "planets.ron", "fixed"],
    ["environment_f32", "environment.ron", "f32"],
    ["still_life_f32", "still-life", "f32"],
    ["smooth_fixed", "smooth", "fixed"],
    // Every kind of hierarchy, over triangles and over objects.
    ["vase_kd", "vase.obj", "fixed --accel kd"],
    ["vase_octree", "vase.obj", "fixed --accel octree"],
    ["vase_grid", "vase.obj", "fixed --accel grid"],
    ["vase_none", "vase.obj", "fixed --accel none"],
    ["temple_kd", "temple.ron", "fixed --accel kd"],
    ["temple_octree", "temple.ron", "fixed --accel octree"],
    ["temple_grid", "temple.ron", "f32 --accel grid"],
    // Meshes and voxels of the gallery.
    ["teapot_fixed", "teapot", "fixed"],
    ["teapot_grid", "teapot", "f32 --accel grid"],
    ["phantom_fixed", "phantom", "fixed"],
    ["isosurface_f32", "isosurface", "f32"],
];

fn project() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

/// Makes a desk with the files, and a program of its own with each of them baked.
fn workshop(test: &str) -> Desk {
    let desk = Desk::new(test);
    crate::model_files::write(&desk.0);
    for entry in fs::read_dir(project().join("scenes")).unwrap() {
        let path = entry.unwrap().path();
        if path.is_file() {
            fs::copy(&path, desk.0.join(path.file_name().unwrap())).unwrap();
        }
    }
    fs::create_dir_all(desk.0.join("src")).unwrap();
    let manifest = format!(
        "[workspace]\n[package]\nname = \"baked\"\nedition = \"2024\"\n[dependencies]\nscanray = {{ path = {:?} }}\n\
         embedded-graphics-core = \"0.4.1\"\n[profile.dev]\nopt-level = 2\n",
        project()
    );
    fs::write(desk.0.join("Cargo.toml"), manifest).unwrap();
    // The very versions that the project has: nothing is asked of a registry.
    fs::copy(project().join("Cargo.lock"), desk.0.join("Cargo.lock")).unwrap();
    let modules: String = BAKED.iter().map(|[name, ..]| format!("pub mod {name};\n")).collect();
    let library = format!("//! Baked scenes.\n#![no_std]\n#![deny(warnings, missing_docs)]\n\n{modules}");
    fs::write(desk.0.join("src/lib.rs"), library.replace("pub mod", "/// A scene.\npub mod")).unwrap();
    for [name, scene, number] in BAKED {
        let output = desk.run(&format!("bake {scene} --number {number} -o src/{name}.rs"));
        assert!(output.status.success(), "{name}: {output:?}");
    }
    desk
}

/// Builds the program in a folder that stays, so that the core is compiled once.
fn cargo(desk: &Desk, arguments: &str) -> Output {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap());
    command.arg("--offline").args(arguments.split_whitespace()).current_dir(&desk.0);
    command.env("CARGO_TARGET_DIR", PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("baked"));
    // Wrappers and flags are those of the test's own build.
    command.env_remove("RUSTFLAGS").output().unwrap()
}

/// Is a program that draws each scene into a file of its panel's bytes.
const PROGRAM: &str = r#"
use embedded_graphics_core::geometry::Size;
use scanray::{Renderer, Workspace};

macro_rules! draw {
    ($($scene:ident)*) => {$({
        use baked::$scene::{CAMERA, SCENE, SETTINGS, SIZE};
        let mut workspace = Workspace::<_, [u8; 2], 0, 8>::new();
        let size = Size::new(SIZE[0], SIZE[1]);
        let mut renderer = Renderer::new(&SCENE, &CAMERA, size, SETTINGS, &mut workspace).unwrap();
        let mut row = vec![[0; 2]; SIZE[0] as usize];
        let mut bytes = vec![];
        for y in 0..SIZE[1] {
            renderer.render_row(y, &mut row).unwrap();
            bytes.extend(row.as_flattened());
        }
        std::fs::write(concat!(stringify!($scene), ".rgb565"), bytes).unwrap();
    })*};
}
"#;

fn spread(level: u8, top: u8) -> u8 {
    ((u32::from(level) * 255 + u32::from(top) / 2) / u32::from(top)) as u8
}

#[test]
fn a_baked_scene_compiles_as_it_is_and_draws_the_picture_of_its_file() {
    let desk = workshop("bake");
    let names: Vec<&str> = BAKED.iter().map(|[name, ..]| *name).collect();
    let program = format!("{PROGRAM}\nfn main() {{\n    draw!({});\n}}\n", names.join(" "));
    fs::write(desk.0.join("src/main.rs"), program).unwrap();
    let output = cargo(&desk, "run --quiet");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for [name, scene, options] in BAKED {
        let number = options.split(' ').next().unwrap();
        let output = desk.run(&format!("render {scene} --number {number} -o {name}.png"));
        assert!(output.status.success(), "{name}: {output:?}");
        let bytes = fs::read(desk.0.join(format!("{name}.rgb565"))).unwrap();
        let pixels = bytes.as_chunks().0.iter().map(|bytes| {
            let color = Rgb565::from(RawU16::new(u16::from_be_bytes(*bytes)));
            [spread(color.r(), 31), spread(color.g(), 63), spread(color.b(), 31)]
        });
        let drawn = read(&desk.0.join(format!("{name}.png"))).0;
        assert!(drawn.iter().any(|pixel| *pixel != drawn[0]), "{name} is empty");
        assert!(pixels.eq(drawn), "{name} draws another picture");
    }
}

#[test]
#[ignore = "needs the target thumbv6m-none-eabi"]
fn a_baked_scene_is_free_of_warnings_on_a_chip_without_a_system() {
    let desk = workshop("bake-thumb");
    let output = cargo(&desk, "clippy --lib --target thumbv6m-none-eabi -- -D warnings");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn what_is_baked_is_told_with_its_bytes_and_they_add_up() {
    let desk = Desk::new("bake-told");
    crate::model_files::write(&desk.0);
    let output = desk.run("bake vase.obj --number fixed");
    assert!(output.status.success(), "{output:?}");
    let (told, text) = (stdout(&output), fs::read_to_string(desk.0.join("vase.rs")).unwrap());
    for word in ["number     fixed", "2 objects", "precision", "degrees", "flash", "vase.rs"] {
        assert!(told.contains(word), "no {word:?} in {told}");
    }
    // 32 triangles of the foot's disc have no area, as its corners are in one place.
    assert!(told.contains("610 triangles of") && told.contains("32 triangles that have no area"), "{told}");
    let bytes = |kind: &str| -> usize {
        let row = text.lines().find(|line| line.starts_with(&format!("//! | {kind} |"))).unwrap();
        row.split('|').nth(2).unwrap().trim().parse().unwrap()
    };
    assert_eq!((bytes("triangles"), bytes("images")), (610 * 6, 16 * 16 * 3));
    let kinds = [
        "triangles",
        "corners",
        "normals",
        "meshes",
        "hierarchies",
        "objects",
        "materials",
        "lights",
        "images",
    ];
    assert_eq!(kinds.map(bytes).iter().sum::<usize>(), bytes("all"));
    let wide = text.lines().find(|line| line.len() > 110);
    assert_eq!(wide, None);
}

#[test]
fn a_volume_is_told_with_its_voxels_and_their_bytes() {
    let desk = Desk::new("bake-volume");
    let told = stdout(&desk.run("bake phantom"));
    // A value for each of 48 x 60 x 56, and two for each of 12 x 15 x 14 blocks.
    for word in ["3 objects, 161280 voxels", "voxels 166320", "volumes"] {
        assert!(told.contains(word), "no {word:?} in {told}");
    }
}

#[test]
fn what_several_objects_share_is_written_once() {
    for (view, words) in [
        (gallery::float::TEAPOT, ["static MESH_", "static TRIANGLES_"]),
        (gallery::float::ISOSURFACE, ["static GRID_", "const VOXELS_"]),
    ] {
        let (mut twice, mut exact) = (view, *f64::find(view.name).unwrap());
        twice.scene.objects = vec![view.scene.objects[0]; 2].leak();
        exact.scene.objects = vec![exact.scene.objects[0]; 2].leak();
        let grown = meshes::grow(&twice, &exact, Accel::Bvh);
        let source = Planted { view: twice, grown, tree: None }.write().unwrap();
        for word in words {
            assert_eq!(source.items.matches(word).count(), 1, "{word}");
        }
    }
}

#[test]
fn the_firmwares_scene_is_what_its_file_is_baked_to() {
    let desk = Desk::new("bake-firmware");
    fs::copy(project().join("scenes/nff/balls2.nff"), desk.0.join("balls2.nff")).unwrap();
    let output = desk.run("bake balls2.nff --number fixed --accel bvh -o -");
    let kept = fs::read_to_string(project().join("examples/boards/balls2.rs")).unwrap();
    assert!(
        stdout(&output) == kept,
        "examples/boards/balls2.rs is another scene; its list says how to bake it"
    );
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    let desk = Desk::new("bake-refused");
    crate::model_files::write(&desk.0);
    let before = desk.files();
    assert_refused(&desk, "bake vase.obj --flash 4K", &["bytes", "more than the 4096"]);
    assert_refused(&desk, "bake phantom --flash 128K", &["bytes", "more than the 131072"]);
    assert_refused(&desk, "bake vase.obj --flash much", &["2M"]);
    assert_refused(&desk, "bake none.obj", &["none.obj"]);
    assert_refused(&desk, "bake simple --exact", &["--exact", "OBJ"]);
    assert_refused(&desk, "bake simpel", &["did you mean 'simple'"]);
    assert_refused(&desk, "bake vase.obj --smooth 200", &["0 to 180"]);
    fs::write(desk.0.join("line.obj"), "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n").unwrap();
    assert_refused(&desk, "bake line.obj", &["line.obj", "no face that has an area"]);
    fs::remove_file(desk.0.join("line.obj")).unwrap();
    fs::write(
        desk.0.join("far.ron"),
        "Scene(camera: (eye: (0, 0, 5000), center: (0, 0, 0), \
        projection: Perspective(fovy: 40)))",
    )
    .unwrap();
    assert_refused(&desk, "bake far.ron --number fixed", &["far.ron"]);
    fs::remove_file(desk.0.join("far.ron")).unwrap();
    assert_eq!(desk.files(), before);
}

#[test]
fn a_model_is_taken_wherever_a_scene_is() {
    let desk = Desk::new("bake-model");
    crate::model_files::write(&desk.0);
    let list = stdout(&desk.run("list vase.obj"));
    assert!(list.starts_with("vase  320x240  a model of 610 triangles"), "{list}");
    let output = desk.run("compare vase.obj --json");
    let figures: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    for row in figures.as_array().unwrap() {
        let decibels = row["psnr_db"].as_f64().unwrap();
        assert!(decibels > 55.0, "{row}");
    }
}
