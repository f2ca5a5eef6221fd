//! The reference is worth nothing unless it is independent: its sources are read here.

use std::path::Path;
use std::{fs, io};

/// Is the one file that may name the core.
const DOOR: &str = "door.rs";

/// Lists what the door may name: descriptions, none of which calculates.
const DATA: [&str; 30] = [
    "Bitmap",
    "Bump",
    "Camera",
    "Class",
    "Corners",
    "Dither",
    "FillRule",
    "Filter",
    "Fresnel",
    "Glass",
    "Gradient",
    "Grid",
    "Image",
    "Light",
    "Material",
    "Mesh",
    "Model",
    "Normals",
    "Object",
    "Projection",
    "Reconstruction",
    "Relief",
    "Rgb",
    "Scene",
    "Settings",
    "Shape",
    "Sky",
    "Texture",
    "Transfer",
    "Volume",
];
const ALSO_DATA: &str = "Vec3";

/// Lists the methods the door may call: those of slices, options and iterators, those of an image or a
/// grid that read its texels or voxels out, and one of its own that takes meshes apart.
const METHODS: [&str; 16] = [
    "as_ref",
    "clone",
    "collect",
    "concat",
    "enumerate",
    "facets",
    "get",
    "into_iter",
    "iter",
    "map",
    "ok_or",
    "sides",
    "size",
    "texel",
    "transpose",
    "value",
];

/// Lists what no other file may contain: ways to the core, to the rest of this crate, around this
/// test.
const WAYS: [&str; 7] =
    ["scanray", "crate::", "host_sim", "super::super", "embedded_graphics", "include!", "#[path"];

/// Answers a source without comments and the texts of strings.
fn code(source: &str) -> String {
    let line = |line: &str| line.split("//").next().unwrap_or("").to_owned();
    let lines: Vec<String> = source.lines().map(line).collect();
    lines.join("\n").split('"').step_by(2).collect::<Vec<_>>().join("\"\"")
}

fn word_at(text: &str) -> &str {
    let end = text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len());
    &text[..end]
}

/// Answers what follows each place where a piece of text stands.
fn after<'t>(text: &'t str, piece: &'t str) -> impl Iterator<Item = &'t str> {
    text.match_indices(piece).map(move |(place, _)| &text[place + piece.len()..])
}

/// Answers what is wrong with a name of another module: unknown, or a function of it.
fn name_fault(rest: &str) -> Option<String> {
    let name = word_at(rest);
    if !DATA.contains(&name) && name != ALSO_DATA && name != "Panel" {
        return Some(format!("names `{name}`"));
    }
    let member = rest[name.len()..].strip_prefix("::").map(word_at)?;
    member.starts_with(char::is_lowercase).then(|| format!("calls `{name}::{member}`"))
}

fn door_faults(code: &str) -> Vec<String> {
    let mut faults: Vec<String> = after(code, "scanray::").filter_map(name_fault).collect();
    faults.extend(after(code, "Panel::").filter_map(|rest| name_fault(&format!("Panel::{rest}"))));
    let elsewhere = |rest: &&str| !rest.starts_with("panel::Panel;");
    faults.extend(after(code, "crate::").filter(elsewhere).map(|rest| format!("names `{}`", word_at(rest))));
    let bare = |rest: &&str| !rest.starts_with("::");
    faults.extend(after(code, "scanray").filter(bare).map(|_| "names the core by another way".to_owned()));
    for rest in after(code, ".") {
        let method = word_at(rest);
        let called = rest[method.len()..].starts_with(['(', ':']);
        if called && !METHODS.contains(&method) {
            faults.push(format!("calls `.{method}`"));
        }
    }
    let plain = code.replace("->", "").replace("match *none", "");
    faults.extend(plain.chars().filter(|c| "+-*/%".contains(*c)).map(|c| format!("calculates: `{c}`")));
    faults
}

fn faults(file: &str, source: &str) -> Vec<String> {
    let code = code(source);
    if file == DOOR {
        return door_faults(&code);
    }
    WAYS.iter().filter(|way| code.contains(**way)).map(|way| format!("contains `{way}`")).collect()
}

#[test]
fn the_reference_takes_plain_data_from_the_core_and_no_formula() -> io::Result<()> {
    let mut files = 0;
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/reference"))? {
        let path = entry?.path();
        assert!(path.is_file(), "{} would not be read by this test", path.display());
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        assert_eq!(faults(&name, &fs::read_to_string(&path)?), [""; 0], "{name}");
        files += 1;
    }
    assert!(files >= 10, "only {files} files were found");
    Ok(())
}

#[test]
fn a_formula_of_the_core_is_found_in_whatever_way_it_is_borrowed() {
    let door = |source: &str| !faults(DOOR, source).is_empty();
    assert!(door("use scanray::math::Scalar;"));
    assert!(door("fn f(v: scanray::Vec3<f64>) -> f64 { v.dot(v) }"));
    assert!(door("let v = scanray::Vec3::new(1.0, 2.0, 3.0);"));
    assert!(door("let v = s.center + s.offset;"));
    assert!(door("let v = -s.center;"));
    assert!(door("use scanray as core;"));
    assert!(door("use crate::picture::trace;"));
    assert!(door("Panel::show(light)"));
    assert!(door("shape.intersect::<f64>(ray)"));
    assert!(!door(
        "// scanray::math is not used\nfn f(p: &scanray::Plane) {}".replace("Plane", "Shape").as_str()
    ));
    let other = |source: &str| !faults("shape.rs", source).is_empty();
    assert!(other("use scanray::Vec3;"));
    assert!(other("use crate::picture::trace;"));
    assert!(other("use super::super::picture;"));
    assert!(!other("/// As the crate scanray does.\nuse super::vector::Vector;"));
}
