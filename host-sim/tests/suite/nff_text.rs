//! Writes scenes in the Neutral File Format.

use host_sim::nff::scene::{Fill, Light, Scene, Shape, View};
use std::path::{Path, PathBuf};

/// Lists the published files.
pub const PUBLISHED: [&str; 7] = ["balls1", "balls2", "tetra2", "mount1", "teapot1", "tree1", "lattice1"];

/// Answers where a published file is.
pub fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/nff/{name}.nff"))
}

/// Answers the words of a scene, each entity by itself.
pub fn entities(scene: &Scene) -> Vec<Vec<String>> {
    let View { from, at, up, angle, hither, resolution } = &scene.view;
    let mut view = vec!["v".to_owned()];
    for (word, numbers) in [("from", &from[..]), ("at", at), ("up", up), ("angle", &[*angle])] {
        view.push(word.to_owned());
        view.extend(numbers.iter().map(f64::to_string));
    }
    view.extend(["hither".to_owned(), hither.to_string(), "resolution".to_owned()]);
    view.extend(resolution.map(|side| side.to_string()));
    let mut entities = vec![view, entity("b", &scene.background)];
    for Light { position, color } in &scene.lights {
        entities.push(entity("l", &[&position[..], color.as_ref().map_or(&[], |c| c)].concat()));
    }
    for (index, Fill { color: [r, g, b], diffuse, specular, shine, transmittance, index: bent }) in
        scene.fills.iter().enumerate()
    {
        entities.push(entity("f", &[*r, *g, *b, *diffuse, *specular, *shine, *transmittance, *bent]));
        let filled = scene.objects.iter().filter(|object| object.fill == index);
        entities.extend(filled.map(|object| shape(&object.shape)));
    }
    entities
}

/// Writes a scene, an entity a line.
pub fn write(scene: &Scene) -> String {
    entities(scene).iter().map(|words| words.join(" ") + "\n").collect()
}

fn entity(name: &str, numbers: &[f64]) -> Vec<String> {
    [name.to_owned()].into_iter().chain(numbers.iter().map(f64::to_string)).collect()
}

fn shape(shape: &Shape) -> Vec<String> {
    match shape {
        Shape::Sphere { center: [x, y, z], radius } => entity("s", &[*x, *y, *z, *radius]),
        Shape::Cone { ends: [a, b], radii: [p, q] } => entity("c", &[&a[..], &[*p], b, &[*q]].concat()),
        Shape::Polygon(corners) => many("p", corners.len(), &corners.concat()),
        Shape::Patch(corners) => {
            let numbers: Vec<_> = corners.iter().flat_map(|(point, normal)| [*point, *normal]).collect();
            many("pp", corners.len(), &numbers.concat())
        }
    }
}

fn many(name: &str, count: usize, numbers: &[f64]) -> Vec<String> {
    let mut words = entity(name, numbers);
    words.insert(1, count.to_string());
    words
}
