//! A scene with a hierarchy over its objects is the scene without, to the bit.

use host_sim::bake::{Accel, Bounds};
use host_sim::picture;
use host_sim::rounded::Rounded;
use proptest::prelude::*;
use scanray::gallery::View;
use scanray::{
    Camera, Cone, Cuboid, Fixed, Glass, Light, Material, Object, Plane, Rgb, Scene, Settings, Shape, Sphere,
    Vec3,
};

type Point = [f64; 3];

/// Is an object of a random scene: its kind, where it is, how large, which material.
type Thing = (usize, Point, f64, u16);

/// Counts the materials of a scene.
const MATERIALS: u16 = 4;

fn vector<S: Rounded>(point: Point) -> Vec3<S> {
    Vec3::from_array(point.map(S::round))
}

fn shape<S: Rounded>(&(kind, at, size, _): &Thing) -> Shape<S> {
    let off = |by: Point| vector(std::array::from_fn(|axis| at[axis] + size * by[axis]));
    match kind {
        0 => Shape::Sphere(Sphere::new(vector(at), S::round(size))),
        1 => Shape::Cuboid(Cuboid::new(vector(at), off([1.0, 0.7, 1.3]))),
        _ => Shape::Cone(Cone::new(vector(at), S::round(size), off([1.0, 2.0, -0.5]), S::round(0.3 * size))),
    }
}

fn materials<S: Rounded>() -> [Material<S>; MATERIALS as usize] {
    let color = |r, g, b| Rgb::new(S::round(r), S::round(g), S::round(b));
    [
        Material::matte(color(0.8, 0.3, 0.2)).with_specular(color(0.5, 0.5, 0.5), 30),
        Material::matte(color(0.2, 0.4, 0.7)).with_mirror(S::round(0.6)),
        Material::matte(color(0.1, 0.1, 0.1)).with_glass(Glass::new(S::round(0.9), S::round(1.5))),
        Material::matte(color(0.4, 0.6, 0.3)),
    ]
}

fn lights<S: Rounded>() -> [Light<S>; 3] {
    let gray = |level| Rgb::gray(S::round(level));
    [
        Light::point(vector([12.0, 20.0, 9.0]), gray(0.7)),
        Light::point(vector([-1.0, 3.0, 2.0]), gray(0.5)),
        Light::directional(vector([-0.4, 0.8, 0.5]), gray(0.3)),
    ]
}

/// Demands the same light of every pixel with every kind of hierarchy as with none.
///
/// Endless planes come last: no hierarchy holds them.
fn check<S: Rounded + Send + Sync>(things: &[Thing]) -> Result<(), TestCaseError> {
    let bounds: Vec<Bounds> =
        things.iter().filter_map(|thing| Bounds::of_shape(&shape::<f64>(thing))).collect();
    prop_assert_eq!(bounds.len(), things.len());
    let mut objects: Vec<Object<S>> = things.iter().map(|thing| Object::new(shape(thing), thing.3)).collect();
    for (point, normal, material) in
        [([0.0, -6.0, 0.0], [0.0, 1.0, 0.0], 3), ([0.0, 0.0, -30.0], [0.0, 0.6, 0.8], 1)]
    {
        objects.push(Object::new(Shape::Plane(Plane::new(vector(point), vector(normal))), material));
    }
    // A view of the gallery is `static`.
    let (materials, lights) = (Box::leak(Box::new(materials())), Box::leak(Box::new(lights())));
    let scene = Scene::new(objects.leak(), materials, lights).with_ambient(Rgb::gray(S::round(0.1)));
    let eye = [vector([3.0, 4.0, 22.0]), Vec3::ZERO, vector([0.0, 1.0, 0.0])];
    let draw = |scene| {
        let camera = Camera::perspective(eye[0], eye[1], eye[2], S::round(45.0));
        let settings = Settings::new().with_depth(3);
        let view = View { name: "random", about: "random things", scene, camera, settings, size: [40, 30] };
        picture::trace(&view, settings, view.size, |_| ()).unwrap().light
    };
    let without = draw(scene);
    for accel in Accel::ALL {
        let with = draw(scene.with_hierarchy(accel.build(&bounds).leak::<S>()));
        let off = with.iter().zip(&without).position(|(with, without)| with != without);
        prop_assert_eq!(off, None, "{:?}: the pixel at this place", accel);
    }
    Ok(())
}

/// Answers up to so many things of all kinds, each of some material.
fn things(most: usize) -> impl Strategy<Value = Vec<Thing>> {
    let place = prop::array::uniform3(-8.0..8.0);
    let size = prop_oneof![3 => 0.1..0.6, 1 => 0.6..2.5];
    prop::collection::vec((0..3_usize, place, size, 0..MATERIALS), 1..most)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn a_scene_with_any_hierarchy_is_the_one_without_in_f32(things in things(60)) {
        check::<f32>(&things)?;
    }

    #[test]
    fn a_scene_with_any_hierarchy_is_the_one_without_in_fixed_point(things in things(60)) {
        check::<Fixed>(&things)?;
    }

    #[test]
    fn a_scene_with_any_hierarchy_is_the_one_without_in_f64(things in things(60)) {
        check::<f64>(&things)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4, ..ProptestConfig::default() })]

    #[test]
    fn hundreds_of_objects_and_planes_behind_them_are_no_exception(things in things(300)) {
        check::<f32>(&things)?;
        check::<Fixed>(&things)?;
    }
}
