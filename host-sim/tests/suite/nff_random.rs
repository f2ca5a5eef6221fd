//! Whatever a file of the Neutral File Format holds, it is read or refused, and what it says comes back.

use crate::nff_text::{PUBLISHED, entities, path};
use host_sim::nff::scene::{Fill, Light, Object, Scene, Shape, View};
use host_sim::nff::{Note, parse};
use host_sim::scene_file::{self, SceneFile};
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::path::Path;

/// Is what may stand between two words.
const BETWEEN: [&str; 6] = [" ", "\n", "\r\n", "\t", " # 1 2 3\n\n", "#p\r"];

/// Is what may stand where it should not.
const WORDS: [&str; 16] =
    ["v", "b", "l", "f", "c", "s", "p", "pp", "from", "1e999", "NaN", "-0", "4294967295", "1e300", "#", "\n"];

fn point() -> impl Strategy<Value = [f64; 3]> {
    uniform3(-1e6..1e6)
}

fn view() -> impl Strategy<Value = View> {
    (point(), point(), point(), 1.0..179.0, 0.0..10.0, [1..4096_u32, 1..4096]).prop_map(
        |(from, at, up, angle, hither, resolution)| View { from, at, up, angle, hither, resolution },
    )
}

fn fill() -> impl Strategy<Value = Fill> {
    (uniform3(0.0..1.0), 0.0..2.0, 0.0..2.0, 0.0..1e5, 0.0..=1.0, -9.0..9.0).prop_map(
        |(color, diffuse, specular, shine, transmittance, index)| Fill {
            color,
            diffuse,
            specular,
            shine,
            transmittance,
            index,
        },
    )
}

fn shape() -> impl Strategy<Value = Shape> {
    let radius = || -1e3..1e3;
    let cone = ([point(), point()], [0.0..1e3, 0.0..1e3]);
    prop_oneof![
        (point(), radius()).prop_map(|(center, radius)| Shape::Sphere { center, radius }),
        cone.prop_map(|(ends, radii)| Shape::Cone { ends, radii }),
        vec(point(), 3..9).prop_map(Shape::Polygon),
        vec((point(), point()), 3..9).prop_map(Shape::Patch),
    ]
}

fn scene() -> impl Strategy<Value = Scene> {
    let light = (point(), proptest::option::of(uniform3(0.0..1.0)));
    let light = light.prop_map(|(position, color)| Light { position, color });
    let groups = vec((fill(), vec(shape(), 0..6)), 0..5);
    (view(), uniform3(0.0..1.0), vec(light, 0..5), groups).prop_map(|(view, background, lights, groups)| {
        let (fills, shapes): (Vec<_>, Vec<_>) = groups.into_iter().unzip();
        let of =
            |(fill, shapes): (usize, Vec<_>)| shapes.into_iter().map(move |shape| Object { shape, fill });
        let objects = shapes.into_iter().enumerate().flat_map(of).collect();
        Scene { view, background, lights, fills, objects }
    })
}

/// Reads bytes as a user's file; a complaint is shown, a scene is written and read again.
fn use_as_file(bytes: Vec<u8>) {
    match SceneFile::parse(Path::new("x.nff"), bytes) {
        Err(complaint) => assert!(!complaint.to_string().is_empty()),
        Ok(file) => {
            let text = scene_file::write(file.description()).expect("what was read can be written");
            let (again, _) =
                scene_file::parse(&text).unwrap_or_else(|mistake| panic!("{mistake:?} in {text}"));
            assert_eq!(format!("{again:?}"), format!("{:?}", file.description()), "{text}");
            assert!(file.notes().iter().map(Note::to_string).all(|note| note.starts_with("line")));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn every_value_comes_back_however_the_words_are_laid_out(
        scene in scene(),
        between in vec(select(&BETWEEN[..]), 1..40),
    ) {
        let words = entities(&scene).concat();
        let pairs = words.iter().zip(between.iter().cycle());
        let text: String = pairs.flat_map(|(word, between)| [word, *between]).collect();
        let (read, _) = parse(&text).unwrap_or_else(|mistake| panic!("{mistake:?} in {text}"));
        prop_assert_eq!(read, scene);
    }

    #[test]
    fn a_scene_with_anything_in_it_is_used_or_refused(scene in scene()) {
        use_as_file(crate::nff_text::write(&scene).into_bytes());
    }

    #[test]
    fn a_changed_file_is_read_or_refused(
        name in select(&PUBLISHED[..]),
        cut in (any::<Index>(), 0_usize..40),
        put in vec((any::<Index>(), select(&WORDS[..])), 0..4),
    ) {
        let mut bytes = std::fs::read(path(name)).expect("it is there");
        let begin = cut.0.index(bytes.len());
        bytes.drain(begin..bytes.len().min(begin + cut.1));
        for (at, word) in put {
            let at = at.index(bytes.len());
            bytes.splice(at..at, word.bytes());
        }
        use_as_file(bytes);
    }

    #[test]
    fn noise_is_read_or_refused(bytes in vec(any::<u8>(), 0..200)) {
        use_as_file(bytes);
    }

    #[test]
    fn words_in_any_order_are_read_or_refused(words in vec(select(&WORDS[..]), 0..60)) {
        use_as_file(words.join(" ").into_bytes());
    }
}
