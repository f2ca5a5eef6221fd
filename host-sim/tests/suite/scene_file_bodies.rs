//! Meshes and voxels of scene files: how they stand in a scene, and what is told of one that cannot be taken.

use host_sim::panel::Panel;
use host_sim::picture::trace;
use host_sim::scene_file::mesh::are_alike;
use host_sim::scene_file::{Complaint, SceneFile};
use host_sim::scenes;
use scanray::{Corners, Mesh, Normals, Shape};
use std::fs::{self, File};
use std::path::Path;
use tempfile::TempDir;

/// Is a tetrahedron with a corner in the origin and edges along the axes, in the words of a 3D program.
const TETRAHEDRON: &str = "\
mtllib nowhere.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
usemtl unknown
f 1 3 2
f 1 2 4
f 1 4 3
usemtl other
f 2 3 4
";

/// Makes a folder with a file in it.
fn folder(name: &str, text: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join(name), text).unwrap();
    folder
}

/// Reads a scene of one object, whose shape stands in the fifth line.
fn read(folder: &Path, shape: &str) -> Result<SceneFile, Box<Complaint>> {
    let text = format!(
        "Scene(
    camera: (eye: (3, 2, 5), center: (0, 0, 0), projection: Perspective(fovy: 40)),
    materials: {{ \"clay\": (color: 0.8) }}, lights: [Directional(toward: (1, 2, 3), color: 1)],
    objects: [(material: \"clay\",
        shape: {shape})],
)
"
    );
    SceneFile::parse(&folder.join("scene.ron"), text.into_bytes())
}

/// Answers the mesh of a scene.
fn mesh(folder: &Path, shape: &str) -> &'static Mesh<f64> {
    let file = read(folder, shape).unwrap_or_else(|complaint| panic!("{complaint}"));
    match file.description().objects[0].0.in_number() {
        Shape::Mesh(mesh) => mesh,
        other => panic!("{other:?}"),
    }
}

/// Demands what is told, and what is underlined.
fn assert_told(folder: &Path, shape: &str, says: &str, underlined: &str) {
    let complaint = read(folder, shape).expect_err(shape).to_string();
    let folder = format!("{}/", folder.display());
    let told = complaint.replace(&folder, "");
    let lines: Vec<&str> = told.lines().collect();
    assert!(lines[0].starts_with(says), "{told}");
    let carets = lines[4].find('^').unwrap_or_else(|| panic!("nothing is underlined: {told}"));
    assert!(lines[3][carets..].starts_with(underlined), "{told}");
    assert_eq!(lines[4].matches('^').count(), underlined.chars().count(), "{told}");
}

#[test]
fn a_mesh_that_is_scaled_turned_and_moved_is_the_one_whose_file_is() {
    let folder = folder("t.obj", TETRAHEDRON);
    // Doubled, turned by a quarter about y, x goes to -z and z to x; then moved.
    let placed = "v 5 0 0\nv 5 0 -2\nv 5 2 0\nv 7 0 0\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    fs::write(folder.path().join("placed.obj"), placed).unwrap();
    let words = "Mesh(file: \"t.obj\", scale: 2, turn: (0, 90, 0), at: (5, 0, 0))";
    let [a, b] = [words, "Mesh(file: \"placed.obj\")"].map(|words| mesh(folder.path(), words));
    assert!(are_alike(a, b), "{a:?} is not {b:?}");
    assert!(!are_alike(a, mesh(folder.path(), "Mesh(file: \"t.obj\")")));
}

#[test]
fn a_mesh_is_told_exactly_or_in_the_steps_of_a_box() {
    let folder = folder("t.obj", TETRAHEDRON);
    let of =
        |corners: &str| mesh(folder.path(), &format!("Mesh(file: \"t.obj\", corners: {corners})")).corners;
    assert!(matches!(of("Exact"), Corners::Exact(places) if places.len() == 4));
    let Corners::Quantized { low, sides, steps } = of("Steps(low: (-1, -1, -1), sides: (4, 4, 8))") else {
        panic!("they are not told in steps")
    };
    assert_eq!((low.to_array(), sides.to_array()), ([-1.0; 3], [4.0, 4.0, 8.0]));
    let mut steps = steps.to_vec();
    steps.sort_unstable();
    // A quarter of 4 and an eighth of 8 is where the origin lies, and a unit is as much again.
    let (origin, along) = ([16_384, 16_384, 8_192], [32_768, 32_768, 16_384]);
    let moved = |axis: usize| {
        let mut place = origin;
        place[axis] = along[axis];
        place
    };
    assert_eq!(steps, [origin, moved(2), moved(1), moved(0)]);
}

#[test]
fn normals_are_those_of_the_file_none_or_smoothed() {
    let lit = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0.6 0.8\nf 1//1 2//1 3//1\n";
    let folder = folder("lit.obj", lit);
    let of = |fields: &str| {
        mesh(folder.path(), &format!("Mesh(file: \"lit.obj\", corners: Exact{fields})")).normals
    };
    let is = |normals: Normals<f64>, direction: [f64; 3]| {
        let near = |normal: &scanray::Vec3<f64>| {
            normal.to_array().iter().zip(direction).all(|(a, b)| (a - b).abs() < 1e-12)
        };
        matches!(normals, Normals::Exact(normals) if normals.iter().all(near))
    };
    assert!(is(of(""), [0.0, 0.6, 0.8]));
    assert!(is(of(", turn: (-90, 0, 0)"), [0.0, 0.8, -0.6]));
    assert_eq!(of(", flat: true"), Normals::Flat);
    assert!(is(of(", flat: true, smooth: 30"), [0.0, 0.0, 1.0]));
}

#[test]
fn every_hierarchy_draws_the_same_picture() {
    let folder = folder("t.obj", TETRAHEDRON);
    let draw = |accel: &str| {
        let camera = "camera: (eye: (3, 2, 5), center: (0.3, 0.3, 0.3), projection: Perspective(fovy: 20))";
        let shape = format!("Mesh(file: \"t.obj\", smooth: 100{accel})");
        let objects = format!("objects: [(material: \"clay\", shape: {shape})]");
        let text = format!("Scene({camera}, ambient: 1, materials: {{ \"clay\": (color: 0.8) }}, {objects})");
        let path = folder.path().join("scene.ron");
        fs::write(&path, text).unwrap();
        let view = scenes::read(&path).unwrap_or_else(|failure| panic!("{failure}")).fixed;
        let film = trace(view, view.settings, [48, 36], |_| ()).expect("it can be drawn");
        film.on_panel(Panel::Rgb888, view.settings.transfer, view.settings.dither).concat()
    };
    let usual = draw("");
    assert!(usual.iter().filter(|level| **level > 0).count() > 300, "the mesh is not to be seen");
    for accel in ["bvh", "kd", "octree", "grid", "none"] {
        assert!(draw(&format!(", accel: {accel}")) == usual, "{accel}");
    }
}

#[test]
fn what_is_wrong_with_a_mesh_is_told_where_it_is_named() {
    let folder = folder("teapot.obj", TETRAHEDRON);
    fs::write(folder.path().join("broken.obj"), "# two lines\nusemtl x\nv 0 0 zero\n").unwrap();
    fs::write(folder.path().join("empty.obj"), "v 0 0 0\nv 1 0 0\nf 1 2 1\n").unwrap();
    fs::create_dir(folder.path().join("folder")).unwrap();
    let told =
        |shape: &str, says: &str, underlined: &str| assert_told(folder.path(), shape, says, underlined);
    let missing = "cannot read the mesh teapto.obj: there is no such file, did you mean `teapot.obj`?";
    told("Mesh(file: \"teapto.obj\")", missing, "teapto.obj");
    told("Mesh(file: \"zzz\")", "cannot read the mesh zzz: there is no such file", "zzz");
    told("Mesh(file: \"folder\")", "cannot read the mesh folder: it is no file", "folder");
    let broken = "cannot read the mesh broken.obj: line 3: `v` takes 3 numbers";
    told("Mesh(file: \"broken.obj\")", broken, "broken.obj");
    told("Mesh(file: \"teapot.obj\", acel: kd)", "unknown field `acel`, did you mean `accel`?", "acel");
    told("Mesh(file: \"teapot.obj\", accel: bhv)", "unknown accel `bhv`, did you mean `bvh`?", "bhv");
    let of_fields = [
        ("empty.obj\"", "no triangle of it has an area"),
        ("teapot.obj\", scale: 0", "`scale` is above 0"),
        ("teapot.obj\", at: (0, 1e13, 0)", "`at` and `turn` are numbers"),
        ("teapot.obj\", smooth: NaN", "`smooth` is an angle from 0 to 180 degrees"),
        (
            "teapot.obj\", corners: Steps(low: (0, 0, 0), sides: (1, 1, 0))",
            "the sides of `Steps` are above 0",
        ),
        (
            "teapot.obj\", corners: Steps(low: (0, 0, 0.5), sides: (9, 9, 9))",
            "the box of `Steps` does not hold",
        ),
    ];
    for (fields, says) in of_fields {
        // The object is underlined up to the end of its first line.
        told(&format!("Mesh(file: \"{fields})"), says, "(material: \"clay\",");
    }
}

/// Writes a fan of flat triangles around the origin, none of which lies on another.
fn fan(count: usize) -> String {
    let spoke = |index: usize| (index as f64 / count as f64 * 3.0).sin_cos();
    let mut text = String::from("v 0 0 0\n");
    for index in 0..=count {
        let (y, x) = spoke(index);
        text += &format!("v {x} {y} 0\n");
    }
    for index in 0..count {
        text += &format!("f 1 {} {}\n", index + 2, index + 3);
    }
    text
}

#[test]
fn a_mesh_larger_than_can_be_numbered_or_put_in_cells_is_refused() {
    let folder = folder("large.obj", &fan(65_535));
    let told = |fields: &str| {
        let shape = format!("Mesh(file: \"large.obj\"{fields})");
        read(folder.path(), &shape).expect_err(&shape).to_string()
    };
    // A fan has two corners more than triangles.
    let exact = told(", corners: Exact");
    assert!(exact.starts_with("a mesh has at most 65535 triangles and 65535 corners"), "{exact}");
    fs::write(folder.path().join("large.obj"), fan(16_385)).unwrap();
    for accel in ["kd", "octree", "grid"] {
        let told = told(&format!(", corners: Exact, accel: {accel}"));
        assert!(told.starts_with("`kd`, `octree` and `grid` take at most 16384 triangles"), "{told}");
    }
    // All of them reach across the whole box, whatever the cells.
    let across = |index: usize| format!("v 0 0 {index}\nv 0 1 0\nv 1 0 {}\nf -3 -2 -1\n", 8_000 - index);
    fs::write(folder.path().join("large.obj"), (0..8_000).map(across).collect::<String>()).unwrap();
    assert!(told(", corners: Exact, accel: grid").starts_with("`kd`, `octree` and `grid` take"));
}

#[test]
fn the_meshes_of_a_scene_have_a_bound_together_and_a_file_too_large_is_not_read() {
    let folder = folder("half.obj", &fan(60_000));
    let object = "(material: \"clay\", shape: Mesh(file: \"half.obj\", accel: none)),";
    let scene = |count: usize| {
        let camera = "camera: (eye: (3, 2, 5), center: (0, 0, 0), projection: Perspective(fovy: 40))";
        let objects = object.repeat(count);
        let text = format!("Scene({camera}, materials: {{ \"clay\": (color: 1) }}, objects: [{objects}])");
        SceneFile::parse(&folder.path().join("scene.ron"), text.into_bytes())
    };
    let told = scene(9).expect_err("nine times 60000 are too many").to_string();
    assert!(told.contains("the meshes of a scene have at most 524280 triangles together"), "{told}");
    // A hole of a terabyte takes no room on the disk.
    let hole = File::create(folder.path().join("hole.obj")).unwrap();
    if hole.set_len(1 << 40).is_ok() {
        let says = "cannot read the mesh hole.obj: the files of a scene's meshes have at most 67108864 bytes";
        assert_told(folder.path(), "Mesh(file: \"hole.obj\")", says, "hole.obj");
    }
}

const ISOSURFACE: &str =
    "Isosurface(grid: (file: \"f.raw\", size: (3, 2, 2), low: (0, 0, 0), spacing: (1, 1, 1)), level: 9)";

#[test]
fn voxels_lie_in_their_file_x_first_and_z_last() {
    let folder = folder("f.raw", "");
    fs::write(folder.path().join("f.raw"), (0..12).collect::<Vec<u8>>()).unwrap();
    let file = read(folder.path(), ISOSURFACE).unwrap_or_else(|complaint| panic!("{complaint}"));
    let Shape::Isosurface(surface) = file.description().objects[0].0.in_number::<f32>() else {
        panic!("it is another shape")
    };
    let voxels = surface.grid.voxels;
    let values = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [2, 1, 1]].map(|place| voxels.value(place));
    assert_eq!((values, voxels.sides(), surface.level), ([1, 3, 6, 11], [3, 2, 2], 9.0));
}

#[test]
fn what_is_wrong_with_voxels_is_told_where_they_are_named() {
    let folder = folder("f.raw", "twelve bytes");
    let told = |piece: &str, by: &str, says: &str, underlined: &str| {
        assert_eq!(ISOSURFACE.matches(piece).count(), 1, "{piece}");
        assert_told(folder.path(), &ISOSURFACE.replace(piece, by), says, underlined);
    };
    let of_file = |why: &str| format!("cannot read the voxels f.raw: {why}");
    told("f.raw", "g.raw", "cannot read the voxels g.raw: there is no such file", "g.raw");
    told("(3, 2, 2)", "(3, 2, 3)", &of_file("it has 12 bytes, and `size` asks for 18, one a voxel"), "f.raw");
    told("(3, 2, 2)", "(12, 1, 1)", &of_file("`size` is 2 to 1024 voxels along each side"), "f.raw");
    told("level: 9", "level: 256", "object 0: a value is", "(material: \"clay\",");
    told("level", "levle", "unknown field `levle`, did you mean `level`?", "levle");
    // A gigabyte that is all a hole is refused by its size, and is not read.
    let hole = File::create(folder.path().join("f.raw")).unwrap();
    if hole.set_len(1 << 30).is_ok() {
        let says = of_file("the grids of a scene have at most 134217728 voxels together");
        told("(3, 2, 2)", "(1024, 1024, 1024)", &says, "f.raw");
    }
}

#[test]
fn what_is_wrong_with_a_volume_is_shown_in_its_line() {
    let folder = folder("f.raw", "twelve bytes");
    let grid = "grid: (file: \"f.raw\", size: (3, 2, 2), low: (0, 0, 0), spacing: (1, 1, 1))";
    let told = |fields: &str| {
        let camera = "camera: (eye: (3, 2, 5), center: (0, 0, 0), projection: Perspective(fovy: 40))";
        let text = format!("Scene({camera},\nvolume: ({grid}, {fields}))");
        SceneFile::parse(&folder.path().join("scene.ron"), text.into_bytes()).map_err(|told| told.to_string())
    };
    assert!(told("density: 1").is_ok());
    for (fields, says) in [
        ("density: -1", "volume: a value is"),
        ("density: 1, samples: 0", "volume: it takes no samples of a cell"),
        ("density: 1, classes: []", "volume: its classes are none"),
        ("density: 1, sampels: 2", "unknown field `sampels`, did you mean `samples`?"),
    ] {
        let told = told(fields).expect_err(fields);
        assert!(told.starts_with(says) && told.contains("scene.ron:2:"), "{told}");
    }
}
