//! Accounts: what a pixel of a picture is, and how it comes by its light.

use host_sim::explain::{Column, Explanation};
use host_sim::scene_file::{describe, write_object};
use host_sim::shot::{Approach, Number, Picture, Quality, Refusal, Shot};
use host_sim::word::bits;
use serde::Serialize;

/// Is what a pixel is.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Account {
    /// Column and row.
    pub at: [u32; 2],
    /// What the panel shows there, in 8 bits a channel.
    pub shown: [u8; 3],
    /// The bits it was sent for it.
    pub bits: String,
    /// What the ray through its middle meets first.
    pub met: String,
    /// The same in the words of scene files, if it is an object.
    pub words: Option<String>,
    /// The rays that its light comes by; none where no rays are sent.
    pub rays: Option<Rays>,
}

/// Is the rays of a pixel, as `scanray explain` tells them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rays {
    /// Each with all its figures, the numbers in columns beside the reference.
    pub text: String,
    /// Their tree as SVG, in the number of the picture; in `f32` where that is the reference.
    pub tree: String,
    /// Whether the picture's pixel is theirs alone: not where it takes several rays a pixel, or fills some in.
    pub alone: bool,
}

impl Account {
    /// Asks the core and the reference about a pixel of a picture that was drawn of a shot; none beyond it.
    ///
    /// # Errors
    /// What keeps the core or the reference from drawing it.
    pub fn of(shot: &Shot, picture: &Picture, [x, y]: [u32; 2]) -> Result<Option<Self>, Refusal> {
        let row = picture.pixels.chunks(picture.size[0].max(1) as usize).nth(y as usize);
        let Some(shown) = row.and_then(|row| row.get(x as usize)).copied() else { return Ok(None) };
        let explained = explain(shot, [x, y])?;
        let object = object(&explained);
        let named = |index| format!("object {}", explained.names.object(Some(index)));
        let rays = || Rays {
            text: explained.to_string(),
            tree: explained.svg(),
            alone: shot.quality == Quality::Exact,
        };
        Ok(Some(Self {
            at: [x, y],
            shown,
            bits: bits(shot.panel, shown),
            met: veil(&explained) + &object.map_or_else(|| explained.names.object(None).to_owned(), named),
            words: object.and_then(|object| words(shot, object)),
            rays: (shot.approach == Approach::Trace || shot.number == Number::Oracle).then(rays),
        }))
    }
}

/// Explains a pixel in the picture's number and those of devices; a scene that only the former can hold in that alone.
fn explain(shot: &Shot, pixel: [u32; 2]) -> Result<Explanation, Refusal> {
    let own: Vec<Number> = Some(shot.number).filter(|number| *number != Number::Oracle).into_iter().collect();
    let others = [Number::F32, Number::Fixed].into_iter().filter(|number| !own.contains(number));
    let all: Vec<Number> = own.iter().copied().chain(others).collect();
    Explanation::new(*shot, &all, pixel).or_else(|_| Explanation::new(*shot, &own, pixel))
}

/// Answers the pixel as the number of the picture works it out.
fn own(explained: &Explanation) -> &Column {
    let mut columns = explained.columns.iter();
    columns.find(|column| column.name == explained.shot.number.name()).unwrap_or(&explained.reference)
}

/// Answers the object that the ray from the eye meets.
fn object(explained: &Explanation) -> Option<usize> {
    own(explained).visit(1)?.surface.as_ref().map(|surface| surface.object)
}

/// Answers words for the volume where it takes light of that ray.
fn veil(explained: &Explanation) -> String {
    let takes = own(explained).account.veil.is_some_and(|(_, through)| through < 1.0);
    if takes { "the volume, and behind it ".to_owned() } else { String::new() }
}

/// Answers an object in the words of scene files, if there are any.
fn words(shot: &Shot, index: usize) -> Option<String> {
    let description = match shot.scene.file {
        Some(file) => file.drawn().clone(),
        None => describe(shot.scene.double).ok()?,
    };
    write_object(&description, index)?.ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use host_sim::scene_file::SceneFile;
    use host_sim::scenes;
    use std::path::Path;

    fn account(name: &str, at: [u32; 2]) -> Account {
        let shot = Shot { size: [40, 30], ..Shot::new(scenes::find(name).unwrap()) };
        let picture = shot.take(|_| ()).unwrap().picture;
        Account::of(&shot, &picture, at).unwrap().unwrap()
    }

    #[test]
    fn the_first_corner_of_a_ball_before_a_sky_is_sky_and_the_ball_is_told_in_words() {
        let sky = account("first-light", [0, 0]);
        assert_eq!((sky.met.as_str(), sky.words), ("the sky", None));
        let ball = account("first-light", [20, 15]);
        assert!(ball.met.starts_with("object 0 ("), "{}", ball.met);
        assert!(ball.words.unwrap().contains("Sphere("));
        let skull = account("phantom", [20, 15]);
        assert!(skull.met.starts_with("the volume, and behind it "), "{}", skull.met);
    }

    #[test]
    fn the_rays_of_a_pixel_are_told_in_every_number_and_the_tree_is_of_the_pictures_own() {
        let scene = scenes::find("glass").unwrap();
        let told = |number| {
            let shot = Shot { size: [48, 48], number, ..Shot::new(scene) };
            let picture = shot.take(|_| ()).unwrap().picture;
            Account::of(&shot, &picture, [28, 28]).unwrap().unwrap().rays.unwrap()
        };
        for number in Number::ALL {
            let rays = told(number);
            let heading = rays.text.lines().nth(1).unwrap().to_owned();
            for name in ["f32", "fixed", "oracle", number.name()] {
                assert!(heading.split_whitespace().any(|word| word == name), "{name}: {heading}");
            }
            assert!(rays.text.contains("R1 sets out from the eye"), "{}", rays.text);
            let own = if number == Number::Oracle { "f32" } else { number.name() };
            assert!(rays.tree.contains(&format!("glass 28,28 in {own}<")), "{}", rays.tree);
            assert!(rays.tree.starts_with("<svg ") && rays.tree.contains("T1"), "{}", rays.tree);
        }
    }

    #[test]
    fn a_scene_that_fixed_point_cannot_hold_is_told_in_the_pictures_number_alone() {
        let text = "Scene(objects: [(shape: Sphere(center: (0, 0, -9000), radius: 4000), material: \"red\")], \
            materials: {\"red\": (color: (0.9, 0.1, 0.1))}, lights: [Directional(toward: (1, 1, 1), color: 1)], \
            camera: (eye: (0, 0, 5), center: (0, 0, 0), projection: Perspective(fovy: 40)))";
        let file = SceneFile::parse(Path::new("far.ron"), text.as_bytes().to_vec()).unwrap();
        let shot = Shot { size: [8, 6], ..Shot::new(scenes::keep(file)) };
        let picture = shot.take(|_| ()).unwrap().picture;
        let account = Account::of(&shot, &picture, [4, 3]).unwrap().unwrap();
        let heading = account.rays.unwrap().text.lines().nth(1).unwrap().to_owned();
        assert!(heading.contains("f32") && !heading.contains("fixed"), "{heading}");
    }

    #[test]
    fn a_pixel_is_told_as_the_picture_has_it() {
        let shot = Shot { size: [40, 30], ..Shot::new(scenes::find("c-ray").unwrap()) };
        let picture = shot.take(|_| ()).unwrap().picture;
        for at in [[0, 0], [11, 7], [39, 29]] {
            let account = Account::of(&shot, &picture, at).unwrap().unwrap();
            assert_eq!(account.shown, picture.pixels[(at[1] * 40 + at[0]) as usize]);
        }
        assert_eq!(Account::of(&shot, &picture, [40, 0]).unwrap(), None);
        assert_eq!(Account::of(&shot, &picture, [0, 30]).unwrap(), None);
    }
}
