//! Scene files say all that the gallery holds, and bring it back to the bit.

use crate::scene_folder::{anywhere, export};
use host_sim::panel::Panel;
use host_sim::picture::trace;
use host_sim::scene_file::mesh::are_alike;
use host_sim::scene_file::{Description, SceneFile, describe, parse, write};
use host_sim::scenes::{self, Entry, HostNumber};
use scanray::{Bitmap, Fixed, Material, Object, Scalar, Scene, Shape, Sky, Voxels};
use std::fmt::Debug;
use std::path::{Path, PathBuf};

/// Writes a scene of the gallery with its images and reads the file.
fn there_and_back(entry: &Entry) -> Description {
    let folder = tempfile::tempdir().unwrap();
    let text = export(entry, folder.path(), "there");
    let file = SceneFile::parse(&folder.path().join("there.ron"), text.into_bytes());
    file.unwrap_or_else(|complaint| panic!("{complaint}")).description().clone()
}

/// Demands that two values have the same bits; equality would take -0 for 0.
fn assert_same(a: &impl Debug, b: &impl Debug, what: &str) {
    assert_eq!(anywhere(&format!("{a:?}")), anywhere(&format!("{b:?}")), "{what}");
}

/// Lists the images of a scene.
fn bitmaps<S: Scalar>(scene: &Scene<'_, S>) -> Vec<Bitmap> {
    let sky: &[Bitmap] = if let Sky::Cube(cube) = &scene.sky { cube.faces } else { &[] };
    let of_material = |material: &Material<S>| {
        [material.texture.image().copied(), material.bump.map(|bump| bump.image)].into_iter().flatten()
    };
    let of_object = |object: &Object<S>| {
        if let Shape::Displaced(ball) = &object.shape { Some(ball.relief) } else { None }
    };
    let surfaces =
        scene.materials.iter().flat_map(of_material).chain(scene.objects.iter().filter_map(of_object));
    sky.iter().copied().chain(surfaces.map(|image| image.bitmap)).collect()
}

/// Demands that images have the same texels, and that the same of them are one.
fn assert_same_images(a: &[Bitmap], b: &[Bitmap], what: &str) {
    let texels = |image: &Bitmap| {
        let [columns, rows] = image.size();
        let row = |row| (0..columns).map(move |column| [column, row]);
        (0..rows).flat_map(row).map(|place| image.texel(place)).collect::<Vec<_>>()
    };
    let one = |images: &[Bitmap]| {
        images.iter().map(|image| images.iter().position(|first| first == image)).collect::<Vec<_>>()
    };
    assert_eq!(one(a), one(b), "{what}");
    assert!(a.iter().map(texels).eq(b.iter().map(texels)), "{what}");
}

/// Lists the values of all voxels of a scene.
fn voxels<S: Scalar>(scene: &Scene<'_, S>) -> Vec<u8> {
    let of_object = |object: &Object<S>| {
        if let Shape::Isosurface(surface) = &object.shape { Some(surface.grid.voxels) } else { None }
    };
    let values = |voxels: Voxels| {
        let [columns, rows, slices] = voxels.sides();
        let places = (0..slices).flat_map(move |z| (0..rows).map(move |y| [y, z]));
        places.flat_map(move |[y, z]| (0..columns).map(move |x| voxels.value([x, y, z])))
    };
    let volume = scene.volume.map(|volume| volume.grid.voxels);
    scene.objects.iter().filter_map(of_object).chain(volume).flat_map(values).collect()
}

/// Demands that two lists have the same objects; meshes may list their corners in another order.
fn assert_same_objects<S: HostNumber>(a: &[Object<S>], b: &[Object<S>], what: &str) {
    assert_eq!(a.len(), b.len(), "{what}");
    for (a, b) in a.iter().zip(b) {
        match (&a.shape, &b.shape) {
            (Shape::Mesh(back), Shape::Mesh(mesh)) => {
                assert!(mesh.triangles.len() > 900 && are_alike(back, mesh), "{what}");
                assert_eq!(a.material, b.material, "{what}");
            }
            _ => assert_same(a, b, what),
        }
    }
}

fn assert_comes_back_in<S: HostNumber>(entry: &Entry, description: &Description) {
    let view = S::view(entry);
    let lists = description.lists::<S>();
    let name = entry.name();
    // Bits of scene, camera, settings and size are all that a picture depends on.
    let scene = description.scene(&lists);
    assert_same_objects(scene.objects, view.scene.objects, name);
    assert_same(&Scene { objects: &[], ..scene }, &Scene { objects: &[], ..view.scene }, name);
    assert!(voxels(&scene) == voxels(&view.scene), "{name}");
    assert_same_images(&bitmaps(&scene), &bitmaps(&view.scene), name);
    assert_same(&description.camera.in_number::<S>(), &view.camera, name);
    assert_same(&description.settings.in_number::<S>(), &view.settings, name);
    assert_eq!((description.size, description.about.as_str()), (view.size, view.about), "{name}");
}

/// Demands the same picture of a view and of the one that was read, in small.
fn assert_same_picture<S: HostNumber>(gallery: &Entry, file: &Entry) {
    let rows = |entry: &Entry| {
        let view = S::view(entry);
        let film = trace(view, view.settings, [80, 60], |_| ()).expect("it can be drawn");
        film.on_panel(Panel::Rgb888, view.settings.transfer, view.settings.dither)
    };
    assert!(rows(gallery) == rows(file), "{}", gallery.name());
}

#[test]
fn meshes_and_voxels_that_come_back_from_a_file_draw_the_same_picture_in_every_number() {
    for name in ["teapot", "knot", "phantom", "isosurface"] {
        let entry = scenes::find(name).expect("it is in the gallery");
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("there.ron");
        std::fs::write(&path, export(&entry, folder.path(), "there")).unwrap();
        let back = scenes::read(&path).unwrap_or_else(|failure| panic!("{failure}"));
        assert_same_picture::<f64>(&entry, &back);
        assert_same_picture::<f32>(&entry, &back);
        assert_same_picture::<Fixed>(&entry, &back);
    }
}

#[test]
fn the_whole_gallery_comes_back_from_files_in_every_number_to_the_bit() {
    for entry in scenes::all() {
        let description = there_and_back(&entry);
        assert_comes_back_in::<f64>(&entry, &description);
        assert_comes_back_in::<f32>(&entry, &description);
        assert_comes_back_in::<Fixed>(&entry, &description);
    }
}

#[test]
fn what_differs_from_the_usual_is_written_and_nothing_else() {
    let simple = scenes::find("simple").expect("it is in the gallery");
    let text = write(&describe(simple.double).unwrap()).unwrap();
    assert!(text.contains("specular: 0.6, shininess: 30") && text.contains("near: 30.0"), "{text}");
    for usual in ["model", "mirror", "settings", "up:", "Some", "None"] {
        assert!(!text.contains(usual), "{usual} is said in {text}");
    }
}

#[test]
fn a_file_that_says_next_to_nothing_is_a_black_scene_with_the_usual_settings() {
    let (description, _) =
        parse("(camera: (eye: (0, 0, 1), center: (0, 0, 0), projection: Perspective(fovy: 40)))").unwrap();
    let lists = description.lists::<f32>();
    assert_eq!(description.scene(&lists), scanray::Scene::new(&[], &[], &[]));
    assert_eq!(description.settings.in_number::<f32>(), scanray::Settings::new());
    let [eye, center, up] = [[0.0, 0.0, 1.0], [0.0; 3], [0.0, 1.0, 0.0]].map(scanray::Vec3::from_array);
    assert_eq!(description.camera.in_number(), scanray::Camera::perspective(eye, center, up, 40.0));
    assert_eq!(description.size, [320, 240]);
}

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

#[test]
fn the_scenes_beside_the_gallery_in_fixed_point_for_rgb565_are_what_has_been_looked_at() {
    let entries = std::fs::read_dir(project("scenes")).unwrap().map(|entry| entry.unwrap().path());
    let files: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|kind| kind == "ron")).collect();
    assert!(files.len() >= 2, "{files:?}");
    for file in files {
        let entry = scenes::read(&file).unwrap_or_else(|failure| panic!("{failure}"));
        let view = entry.fixed;
        let film = trace(view, view.settings, view.size, |_| ()).expect("it can be drawn");
        let drawn = film.on_panel(Panel::Rgb565, view.settings.transfer, view.settings.dither).concat();
        let picture = project("pictures").join(format!("{}.png", entry.name()));
        let looked_at =
            image::open(&picture).unwrap_or_else(|error| panic!("{}: {error}", picture.display()));
        let apart = looked_at.to_rgb8().iter().zip(&drawn).filter(|(a, b)| a != b).count();
        assert_eq!(
            (apart, looked_at.width(), looked_at.height()),
            (0, view.size[0], view.size[1]),
            "{0}: look at it, then `cargo sim render scenes/{0}.ron --number fixed -o pictures/{0}.png`",
            entry.name()
        );
    }
}
