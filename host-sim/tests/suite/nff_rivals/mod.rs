//! The published files of the Neutral File Format, drawn by this renderer and by renderers nobody here wrote.
//!
//! Silhouettes are read off pictures of two kinds. In one each object has a colour of its own, whatever the light;
//! in the other all is white and matt under one lamp, and a pixel is lit or not. Patches are flat in both, and a
//! run of them is one object: some of them coincide.
//!
//! Needs `povray` and `tachyon` (Debian: povray, tachyon).

mod plain;
mod povray;
mod tachyon;

use crate::nff_text::{PUBLISHED, path};
use host_sim::nff::scene::Scene;
use host_sim::panel::Panel;
use host_sim::picture::trace;
use host_sim::rounded::{Rounded, camera_in};
use host_sim::scene_file::SceneFile;
use host_sim::scene_file::material::Model;
use scanray::gallery::View;
use scanray::{Camera, Dither, Fixed, Transfer};
use std::path::Path;
use std::process::Command;

/// Is the share of pixels in which two renderers have to agree.
const LEAST: f64 = 0.995;

/// Is a picture of as many pixels as the file asks for, in the colours that a program wrote.
type Pixels = Vec<[u8; 3]>;

/// Names a kind of picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Objects,
    Light,
}

impl Kind {
    /// Answers what a pixel shows: which object, or whether it is lit; `dark` is what is seen without light.
    fn of(self, [r, g, b]: [u8; 3], dark: u8) -> u32 {
        match self {
            Self::Objects => [r, g, b].iter().fold(0, |number, c| number * plain::DIGITS + plain::digit(*c)),
            Self::Light => u32::from(r > dark + 2),
        }
    }
}

/// Answers the share of pixels in which two pictures show the same.
fn agreement(kind: Kind, ours: &Pixels, theirs: &Pixels, dark: u8) -> f64 {
    assert_eq!(ours.len(), theirs.len());
    let same = |(a, b): &(&[u8; 3], &[u8; 3])| kind.of(**a, 0) == kind.of(**b, dark);
    ours.iter().zip(theirs).filter(same).count() as f64 / ours.len() as f64
}

/// Draws a scene with this renderer, from its text.
fn draw<S: Rounded + Send + Sync>(
    kind: Kind,
    scene: &Scene,
    camera: fn(Camera<f64>) -> Camera<f64>,
) -> Pixels {
    let file = SceneFile::parse(Path::new("x.nff"), crate::nff_text::write(scene).into_bytes());
    let file = file.unwrap_or_else(|complaint| panic!("{complaint}"));
    let mut description = file.drawn().clone();
    if kind == Kind::Objects {
        description.materials.iter_mut().for_each(|(_, material)| material.model = Some(Model::Flat));
    }
    // A view lasts as long as the program.
    let lists: &'static _ = Box::leak(Box::new(description.lists::<S>()));
    let view = View {
        name: "",
        about: "",
        scene: description.scene(lists),
        camera: camera_in(&camera(description.camera.in_number())),
        settings: description.settings.in_number(),
        size: description.size,
    };
    let film = trace(&view, view.settings, view.size, |_| ()).expect("it can be drawn");
    film.on_panel(Panel::Rgb888, Transfer::Linear, Dither::None)
}

/// Runs a program in a directory of its own, with its scene; answers the picture.
fn run(program: &str, arguments: &[&str], [name, text]: [&str; 2]) -> Pixels {
    let desk = tempfile::tempdir().expect("there is room");
    std::fs::write(desk.path().join(name), text).expect("there is room");
    let output = Command::new(program).args(arguments).current_dir(desk.path()).output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error}"));
    let picture =
        image::open(desk.path().join("x.png")).unwrap_or_else(|error| panic!("{error}: {output:?}"));
    picture.into_rgb8().pixels().map(|pixel| pixel.0).collect()
}

#[test]
#[ignore = "needs povray and tachyon"]
fn objects_and_shadows_of_every_published_file_agree_on_995_pixels_of_1000() {
    println!("| file | picture | rival | f32 | fixed |\n|---|---|---|--:|--:|");
    let mut wrong = vec![];
    for name in PUBLISHED {
        let text = std::fs::read_to_string(path(name)).expect("it is there");
        let (scene, _) = host_sim::nff::parse(&text).expect("it has no mistake");
        for kind in [Kind::Objects, Kind::Light] {
            let scene = plain::plain(kind, &scene);
            let povray = (povray::draw(kind, &scene), 0, (|camera| camera) as fn(_) -> _);
            let tachyon = (tachyon::draw(kind, &scene), tachyon::AMBIENT, tachyon::camera as fn(_) -> _);
            for (rival, (theirs, dark, camera)) in [("povray", povray), ("tachyon", tachyon)] {
                let pictures = [draw::<f32>(kind, &scene, camera), draw::<Fixed>(kind, &scene, camera)];
                let [float, fixed] = pictures.map(|ours| agreement(kind, &ours, &theirs, dark));
                println!("| {name} | {kind:?} | {rival} | {:.3} % | {:.3} % |", 100.0 * float, 100.0 * fixed);
                if float.min(fixed) < LEAST {
                    wrong.push((name, kind, rival));
                }
            }
        }
    }
    assert_eq!(wrong, []);
}
