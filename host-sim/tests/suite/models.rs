//! Models of OBJ files: what is read of them, what is refused, and with which line.

use host_sim::bake::Accel;
use host_sim::model::{Model, Options, Plan};
use host_sim::obj::{self, Mistake, Reason};
use proptest::prelude::*;
use scanray::Fixed;
use std::io;
use std::path::Path;

fn parse_with(text: &str, library: &str) -> Result<Model, Mistake> {
    obj::parse(Path::new("model.obj"), text, &mut |_| Ok(library.to_owned()))
}

fn parse(text: &str) -> Result<Model, Mistake> {
    parse_with(text, "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n")
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

#[test]
fn a_polygon_becomes_triangles_that_go_around_the_same_way() {
    let model = parse(SQUARE).unwrap();
    let places: Vec<[[f64; 3]; 3]> =
        model.parts[0].triangles.iter().map(|triangle| triangle.map(|corner| corner.place)).collect();
    let [a, b, c, d] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    assert_eq!(places, [[a, b, c], [a, c, d]]);
    assert_eq!(model.paints[0].color, [0.8; 3]);
}

#[test]
fn triangles_are_gathered_by_their_materials() {
    let face = "f 1 2 3\n";
    let text = format!("mtllib a.mtl\n{SQUARE}usemtl red\n{face}usemtl blue\n{face}usemtl red\n{face}{face}");
    let model = parse(&text).unwrap();
    let counts: Vec<(&str, usize)> =
        model.parts.iter().map(|part| (&*model.paints[part.material].name, part.triangles.len())).collect();
    assert_eq!(counts, [("plain", 2), ("red", 3), ("blue", 1)]);
}

#[test]
fn normals_count_only_where_every_corner_has_one() {
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\n";
    let smooth = |face: &str| {
        let model = parse(&format!("{corners}{face}")).unwrap();
        model.parts[0].triangles[0].map(|corner| corner.normal)
    };
    assert_eq!(smooth("f 1//1 2//1 3//-1"), [Some([0.0, 0.0, 2.0]); 3]);
    assert_eq!(smooth("f 1//1 2 3//1"), [None; 3]);
}

#[test]
fn what_a_library_says_of_light_is_what_is_drawn() {
    let library = "newmtl red\nKd 0.5 0 0\nKs 0.25\nNs 300.4\nKa 0.25 0 0\nd 0.5\nillum 2\nmap_Bump x\n";
    let model = parse_with(&format!("mtllib a.mtl\nusemtl red\n{SQUARE}"), library).unwrap();
    let paint = &model.paints[0];
    assert_eq!((paint.color, paint.specular, paint.shininess), ([0.5, 0.0, 0.0], [0.25; 3], 300));
    assert!((paint.ambient - 0.5).abs() < 1e-12 && paint.lets_light_through);
}

#[test]
fn a_model_of_any_size_in_any_place_suits_fixed_point() {
    for (scale, away) in [(1e-6, 0.0), (1.0, 5.0), (3e4, -1e6), (1e9, 1e10)] {
        let text: String = crate::model_files::vase()
            .lines()
            .map(|line| match line.strip_prefix("v ") {
                Some(place) => {
                    let places = place.split(' ').map(|value| value.parse::<f64>().unwrap() * scale + away);
                    let places: Vec<String> = places.map(|value| value.to_string()).collect();
                    format!("v {}\n", places.join(" "))
                }
                None if line.starts_with("mtllib") || line.starts_with("usemtl") => String::new(),
                None => format!("{line}\n"),
            })
            .collect();
        let plan = Plan::new(parse(&text).unwrap(), Options::default()).unwrap();
        let planted = plan.plant::<Fixed>();
        assert_eq!(planted.view.scene.check(), Ok(()), "{scale}");
        let largest = planted.view.scene.largest().to_f64();
        assert!((60.0..=200.0).contains(&largest), "{scale}: {largest}");
    }
}

#[test]
fn a_mistake_is_told_with_its_line() {
    let says = |text: &str, line: usize, words: &str| {
        let told = parse(text).expect_err(text).to_string();
        assert!(told.starts_with(&format!("model.obj:{line}: ")) && told.contains(words), "{text:?}: {told}");
    };
    says("v 0 0 0\nv 1 two 3\n", 2, "`v` takes 3 numbers");
    says("v 0 0 inf\n", 1, "`v` takes 3 numbers");
    says("v 0 0 0 0\n", 1, "`v` takes 3 numbers");
    says("v 0 0 1e13\n", 1, "`v` takes 3 numbers");
    says("vt 1\n", 1, "`vt` takes 2 numbers");
    says("vt 0 1025\n", 1, "`vt` takes 2 numbers from -1024 to 1024");
    says("\n\nvn 1 0\n", 3, "`vn` takes 3 numbers");
    says(&format!("{SQUARE}f 1 2\n"), 6, "three corners");
    says(&format!("{SQUARE}f\n"), 6, "three corners");
    says(&format!("{SQUARE}f 1 2 x\n"), 6, "`x` is no corner");
    says(&format!("{SQUARE}f 1 2 /3\n"), 6, "`/3` is no corner");
    says(&format!("{SQUARE}f 1 2 3/1/1/1\n"), 6, "is no corner");
    says(&format!("{SQUARE}f 1 2 0\n"), 6, "`v` 0, and there are 4");
    says(&format!("{SQUARE}f 1 2 5\n"), 6, "`v` 5, and there are 4");
    says(&format!("{SQUARE}f 1 \\\n2 -5\n"), 6, "`v` -5, and there are 4");
    says(&format!("{SQUARE}f 1/1 2/1 3/1\n"), 6, "`vt` 1, and there are 0");
    says("mtllib a.mtl\nusemtl rde\n", 2, "no library has a material `rde`, did you mean `red`?");
    says("usemtl\n", 1, "`usemtl` takes a name");
    says("mtllib \n", 1, "`mtllib` takes a name");
}

#[test]
fn a_mistake_of_a_library_is_told_with_the_librarys_line() {
    for (library, words) in [
        ("newmtl a\nKd 1 2\n", "a.mtl:2: `Kd` takes 3 numbers"),
        ("newmtl a\nKd spectral x\n", "a.mtl:2: `Kd` takes 3 numbers"),
        ("Ns\n", "a.mtl:1: `Ns` takes a number"),
        ("newmtl\n", "a.mtl:1: `newmtl` takes a name"),
        ("newmtl a\nillum 300\n", "a.mtl:2: `illum` takes a number"),
        ("newmtl a\nmap_Kd -s 2 2 2 x.png\n", "a.mtl:2: options of maps such as `-s`"),
        ("newmtl a\nmap_Kd no/such.png\n", "such.png"),
    ] {
        let told = parse_with("mtllib a.mtl\n", library).expect_err(library).to_string();
        assert!(told.contains(words), "{library:?}: {told}");
    }
    let missing = obj::parse(Path::new("model.obj"), "\nmtllib none.mtl\n", &mut |path| {
        Err(Reason::Io(io::Error::from(io::ErrorKind::NotFound)).of(path))
    });
    let told = missing.unwrap_err().to_string();
    assert!(told.starts_with("model.obj:2: the library `none.mtl` cannot be read"), "{told}");
}

#[test]
fn what_is_too_much_is_refused_by_its_number() {
    let polygon = format!("v 0 0 0\nf{}\n", " 1".repeat(262_147));
    let told = parse(&polygon).unwrap_err().to_string();
    assert!(told.contains("more than 262144 triangles"), "{told}");
    let changes = format!("mtllib a.mtl\n{}", "usemtl red\nusemtl blue\n".repeat(40_000));
    let told = parse(&changes).unwrap_err().to_string();
    assert!(told.contains("more than 65536 changes of material"), "{told}");
}

/// Demands that whatever can be read can be drawn, or says why not.
fn demand_a_scene_or_a_reason(text: &str, library: &str, options: Options) -> Result<(), TestCaseError> {
    let model = match parse_with(text, library) {
        Ok(model) => model,
        Err(mistake) => {
            prop_assert!(!mistake.to_string().is_empty());
            return Ok(());
        }
    };
    if let Some(plan) = Plan::new(model, options) {
        prop_assert_eq!(plan.plant::<f32>().view.scene.check(), Ok(()));
        prop_assert_eq!(plan.plant::<Fixed>().view.scene.check(), Ok(()));
        prop_assert!(plan.plant::<Fixed>().write().is_ok());
    }
    Ok(())
}

fn options() -> impl Strategy<Value = Options> {
    (prop::option::of(0.0..180.0), any::<bool>(), any::<bool>(), any::<bool>()).prop_map(
        |(smooth, exact, floor, tree)| Options {
            smooth,
            exact,
            floor,
            accel: if tree { Accel::Bvh } else { Accel::None },
        },
    )
}

/// Answers lines as a file may have them, in any order; few of them are wrong.
fn lines() -> impl Strategy<Value = String> {
    let value = prop_oneof![
        20 => (-2.0..2.0).prop_map(|value: f64| format!("{value:.3}")),
        1 => Just("1e12".to_owned()),
        1 => Just("1e-300".to_owned()),
        1 => Just("-0".to_owned()),
    ];
    let values = move |count| prop::collection::vec(value.clone(), count).prop_map(|values| values.join(" "));
    let corners =
        |corner| prop::collection::vec(corner, 3..6).prop_map(|corners: Vec<String>| corners.join(" "));
    let line = prop_oneof![
        40 => ("(v|vn)", values(3..4)).prop_map(|(word, values)| format!("{word} {values}")),
        20 => values(2..3).prop_map(|values| format!("vt {values}")),
        40 => corners("-?[1-3]/[1-3]/-?[12]").prop_map(|corners| format!("f {corners}")),
        20 => corners("-?[1-4](//[12])?").prop_map(|corners| format!("f {corners}")),
        20 => "(g x|o|l 1 2 3|p 1|s off|#.*|mtllib a)",
        1 => "usemtl (red|blue)",
        1 => "(v|vt|vn|f|usemtl|mtllib)[ 0-9/-]{0,12}",
    ];
    prop::collection::vec(line, 0..20).prop_map(|lines| lines.join("\n"))
}

/// Answers a library, in most cases a right one.
fn library() -> impl Strategy<Value = String> {
    let lines = "(newmtl (red|blue)|K[ads] [0-9. -]{0,9}|(Ns|d|Tr|Ni) [0-9.-]{0,4}|illum [0-9]{0,2})";
    prop_oneof![
        3 => Just("newmtl red\nKd 1 0 0\nKs 1 1 1\nnewmtl blue\nillum 0\n".to_owned()),
        1 => prop::collection::vec(lines, 0..12).prop_map(|lines| lines.join("\n")),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn arbitrary_bytes_are_a_model_or_a_mistake(bytes: Vec<u8>, library: Vec<u8>, options in options()) {
        let [text, library] = [bytes, library].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
        demand_a_scene_or_a_reason(&format!("mtllib a\n{text}"), &library, options)?;
    }

    #[test]
    fn arbitrary_lines_are_a_model_or_a_mistake(
        text in lines(),
        library in library(),
        options in options(),
    ) {
        let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 1 0 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
        demand_a_scene_or_a_reason(&format!("mtllib a\n{corners}{text}"), &library, options)?;
    }

    #[test]
    fn a_model_with_a_few_wrong_bytes_is_a_model_or_a_mistake(
        places in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        options in options(),
    ) {
        let mut bytes = crate::model_files::vase().into_bytes();
        for (place, byte) in places {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        let library = crate::model_files::LIBRARY.replace("map_Kd", "# map_Kd");
        demand_a_scene_or_a_reason(&String::from_utf8_lossy(&bytes), &library, options)?;
    }
}
