//! What the desk does with files that were handed over.

use host_sim::scene_file::{describe, write};
use host_sim::scenes;
use host_sim::shot::Shot;
use scanray_playground::desk::Desk;
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};

/// Asks the desk and answers what it says, as a page reads it.
fn ask(desk: &mut Desk, request: Value) -> Value {
    serde_json::to_value(desk.ask(request.to_string().as_bytes())).unwrap()
}

fn hand(desk: &mut Desk, name: &str, bytes: Vec<u8>) {
    let count = bytes.len();
    desk.hand(bytes);
    assert_eq!(ask(desk, json!({ "ask": "take", "name": name })), json!({ "taken": count }));
}

fn fault(desk: &mut Desk, request: Value) -> String {
    let told = ask(desk, request);
    told["fault"].as_str().unwrap_or_else(|| panic!("no fault: {told}")).to_owned()
}

/// Draws the open scene in fixed point.
fn drawn(desk: &mut Desk) -> Vec<u8> {
    let look = json!({ "number": "fixed", "approach": "trace", "panel": "rgb565", "size": [24, 18], "depth": 2,
        "quality": "exact", "side": 1, "dither": "none" });
    let told = ask(desk, json!({ "ask": "frame", "look": look }));
    assert!(told["frame"].is_object(), "{told}");
    desk.pixels().to_vec()
}

/// Opens a scene that was handed over and answers what is told of it.
fn read(desk: &mut Desk, name: &str) -> Value {
    let told = ask(desk, json!({ "ask": "read", "name": name }));
    assert!(told["opened"].is_object(), "{told}");
    told["opened"].clone()
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

/// Writes a scene of the gallery as files, hands over those beside it and answers the text.
fn exported(desk: &mut Desk, name: &str) -> String {
    let mut description = describe(scenes::find(name).unwrap().double).unwrap();
    for file in description.name_files("mine") {
        let path = folder(name).join(file.name());
        file.write(&path).unwrap();
        hand(desk, file.name(), fs::read(path).unwrap());
    }
    write(&description).unwrap()
}

#[test]
fn a_scene_file_with_its_images_meshes_and_voxels_draws_what_the_gallery_draws() {
    for name in ["textured", "teapot", "phantom", "bump"] {
        let mut desk = Desk::default();
        ask(&mut desk, json!({ "ask": "open", "name": name }));
        let gallery = drawn(&mut desk);
        let text = exported(&mut desk, name);
        hand(&mut desk, "mine.ron", text.clone().into_bytes());
        let opened = read(&mut desk, "mine.ron");
        assert_eq!((&opened["name"], &opened["file"]), (&json!("mine"), &json!("mine.ron")));
        assert_eq!(ask(&mut desk, json!({ "ask": "text" }))["text"], text);
        assert!(drawn(&mut desk) == gallery, "{name}");
        // Whoever changes the text still has the files.
        let changed = text.replacen("about: \"", "about: \"Mine: ", 1);
        let told = ask(&mut desk, json!({ "ask": "write", "text": changed, "file": "mine.ron" }));
        assert!(told["opened"]["about"].as_str().unwrap().starts_with("Mine: "), "{told}");
        assert!(drawn(&mut desk) == gallery, "{name}");
    }
}

#[test]
fn a_file_that_is_missing_is_told_by_its_name_and_so_is_the_one_that_was_meant() {
    let mut desk = Desk::default();
    let text = exported(&mut Desk::default(), "textured");
    hand(&mut desk, "mine.ron", text.into_bytes());
    let read = json!({ "ask": "read", "name": "mine.ron" });
    let said = fault(&mut desk, read.clone());
    assert!(said.contains("cannot read the image mine-") && said.contains("there is no such file"), "{said}");
    assert!(said.contains("mine.ron:"), "{said}");
    assert_eq!(
        fault(&mut desk, json!({ "ask": "read", "name": "his.ron" })),
        "the file his.ron was not handed over"
    );
    hand(&mut desk, "notes.txt", vec![]);
    let said = fault(&mut desk, json!({ "ask": "read", "name": "notes.txt" }));
    assert_eq!(said, "notes.txt is no scene: the name of one ends in .ron, .nff or .obj");
    let mesh = exported(&mut Desk::default(), "teapot").replace("mine-mesh.obj", "mine-mess.obj");
    hand(&mut desk, "mine-mesh.obj", vec![]);
    hand(&mut desk, "mine.ron", mesh.into_bytes());
    let said = fault(&mut desk, read);
    assert!(said.contains("did you mean `mine-mesh.obj`?"), "{said}");
}

#[test]
fn a_scene_of_the_databases_is_drawn_as_the_host_draws_it_and_its_notes_are_told() {
    let path = folder("nff").join("balls1.nff");
    let text = fs::read_to_string(project("scenes/nff/balls1.nff")).unwrap();
    // Corners on a line are no triangle.
    fs::write(&path, text + "\np 3\n0 0 0\n1 0 0\n2 0 0\n").unwrap();
    let host = scenes::read(&path).unwrap();
    let mut desk = Desk::default();
    hand(&mut desk, "balls1.nff", fs::read(&path).unwrap());
    let opened = read(&mut desk, "balls1.nff");
    let notes: Vec<String> = host.file.unwrap().notes().iter().map(ToString::to_string).collect();
    assert_eq!(notes.len(), 1);
    assert_eq!((&opened["file"], &opened["notes"]), (&json!("balls1.nff"), &json!(notes)));
    let shot = Shot {
        number: host_sim::shot::Number::Fixed,
        size: [24, 18],
        depth: 2,
        dither: scanray::Dither::None,
        ..Shot::new(host)
    };
    let pixels = shot.take(|_| ()).unwrap().picture.pixels;
    assert!(drawn(&mut desk).iter().copied().eq(pixels.iter().flat_map(|[r, g, b]| [*r, *g, *b, 255])));
    let text = ask(&mut desk, json!({ "ask": "text" }))["text"].as_str().unwrap().to_owned();
    let wrong = text.replacen("resolution", "revolution", 1);
    let said = fault(&mut desk, json!({ "ask": "write", "text": wrong, "file": "balls1.nff" }));
    assert!(said.contains("balls1.nff:"), "{said}");
}

#[test]
fn a_model_comes_with_its_materials_and_their_images_and_its_text_may_be_changed() {
    let mut desk = Desk::default();
    let model =
        "mtllib paints.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl peel\nf 1/1 2/2 3/3\n";
    hand(&mut desk, "sail.obj", model.into());
    let open = json!({ "ask": "read", "name": "sail.obj" });
    let said = fault(&mut desk, open.clone());
    assert!(said.contains("the library `paints.mtl` cannot be read"), "{said}");
    hand(&mut desk, "paints.mtl", "newmtl peel\nKd 1 1 1\nmap_Kd images/peel.png\n".into());
    let said = fault(&mut desk, open);
    assert!(said.contains("images/peel.png: cannot be read"), "{said}");
    hand(&mut desk, "peel.png", fs::read(project("scenes/peel.png")).unwrap());
    assert_eq!(read(&mut desk, "sail.obj")["file"], "sail.ron");
    let picture = drawn(&mut desk);
    let text = ask(&mut desk, json!({ "ask": "text" }))["text"].clone();
    let told = ask(&mut desk, json!({ "ask": "write", "text": text, "of": "sail.obj" }));
    assert!(told["opened"].is_object(), "{told}");
    assert!(drawn(&mut desk) == picture);
}

#[test]
fn files_that_there_is_no_room_for_are_refused_by_name() {
    let mut desk = Desk::default();
    let choices = ask(&mut desk, json!({ "ask": "choices" }));
    let most = choices["choices"]["most_bytes"].as_u64().unwrap();
    hand(&mut desk, "large.raw", vec![0; most as usize]);
    desk.hand(vec![1]);
    let said = fault(&mut desk, json!({ "ask": "take", "name": "small.raw" }));
    assert_eq!(said, format!("with small.raw the files have more than {most} bytes together"));
}
