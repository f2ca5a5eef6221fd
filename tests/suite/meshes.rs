//! Meshes: what their triangles are, and what is wrong with one.

use crate::support::film;
use scanray::accel::{Bvh, BvhNode, Every, Hierarchy, Lattice};
use scanray::gallery::Gallery;
use scanray::hit::Crossing;
use scanray::ray::Ray;
use scanray::*;

/// Answers the teapot of the gallery.
fn teapot<S: Gallery>() -> (&'static gallery::View<S>, &'static Mesh<S>) {
    let view = S::find("teapot").expect("the gallery's teapot");
    match view.scene.objects[0].shape {
        Shape::Mesh(mesh) => (view, mesh),
        other => panic!("{other:?} is no mesh"),
    }
}

/// Answers where the corners of a mesh are.
fn places<S: Scalar>(mesh: &Mesh<S>) -> Vec<Vec3<S>> {
    let Corners::Quantized { low, sides, steps } = mesh.corners else { panic!("the teapot is in steps") };
    let along = |step: u16, side: S| S::from_light_bits(u32::from(step) << 8) * side;
    let place =
        |[x, y, z]: &[u16; 3]| low + Vec3::new(along(*x, sides.x), along(*y, sides.y), along(*z, sides.z));
    steps.iter().map(place).collect()
}

/// Answers the unit normal of a flat triangle.
fn face<S: Scalar>(triangle: &Triangle<S>) -> Vec3<S> {
    let ray = Ray::new(Vec3::ZERO, Vec3::new(S::ZERO, S::ZERO, S::ONE));
    triangle.surface(&ray, &Crossing::at(S::ONE)).normal
}

/// Compares the teapot, flat or with made-up normals, with the smooth triangles that it is made of.
fn compare<S: Gallery>(smooth: bool) {
    let (view, mesh) = teapot::<S>();
    let places = places(mesh);
    // Toward the lid or the foot: on most triangles that is outward, on some it is not.
    let ends = [Vec3::new(S::ZERO, S::ONE, S::ZERO), Vec3::new(S::ZERO, -S::ONE, S::ZERO)];
    let normals: Vec<Vec3<S>> = (0..places.len()).map(|corner| ends[corner % 2]).collect();
    let corner_normals: &'static [Vec3<S>] = normals.clone().leak();
    let how = if smooth { Normals::Exact(corner_normals) } else { Normals::Flat };
    let bare = Box::leak(Box::new(Mesh { normals: how, ..*mesh }));
    let mut taken_apart = Vec::new();
    for corners in mesh.triangles {
        let [a, b, c] = corners.map(|corner| places[usize::from(corner)]);
        let flat = face(&Triangle::new(a, b, c));
        let texture = [[S::ZERO, S::ZERO], [S::ONE, S::ZERO], [S::ZERO, S::ONE]];
        let vertex = |i: usize| {
            let normal = normals[usize::from(corners[i])];
            let normal = if smooth && normal.dot(flat) > S::ZERO { normal } else { flat };
            Vertex::new([a, b, c][i], normal, texture[i])
        };
        let vertices = Box::leak(Box::new([vertex(0), vertex(1), vertex(2)]));
        taken_apart.push(Object::new(Shape::SmoothTriangle(SmoothTriangle::new(vertices)), 0));
    }
    let mut whole = view.scene.objects.to_vec();
    whole[0].shape = Shape::Mesh(bare);
    taken_apart.extend_from_slice(&whole[1..]);
    let draw = |objects: &[Object<S>]| {
        film(&Scene { objects, ..view.scene }, &view.camera, [40, 30], view.settings, &mut ())
    };
    assert!(draw(&whole) == draw(&taken_apart), "smooth: {smooth}");
}

#[test]
fn a_mesh_is_its_smooth_triangles_to_the_bit_in_f32() {
    [false, true].into_iter().for_each(compare::<f32>);
}

#[test]
fn a_mesh_is_its_smooth_triangles_to_the_bit_in_fixed_point() {
    [false, true].into_iter().for_each(compare::<Fixed>);
}

#[test]
fn a_hierarchy_over_objects_changes_no_bit() {
    let balls: Vec<Object> = (0..40)
        .map(|i| {
            let (x, z) = ((i % 8) as f32 - 3.5, (i / 8) as f32 - 2.0);
            Object::new(Shape::Sphere(Sphere::new(Vec3::new(x, 0.4, z), 0.45)), i % 2)
        })
        .chain([Object::new(Shape::Plane(Plane::new(Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0))), 0)])
        .collect();
    let materials = [
        Material::matte(Rgb::new(0.8, 0.3, 0.2)).with_mirror(0.3),
        Material::matte(Rgb::gray(0.05)).with_glass(Glass::new(0.9, 1.5)),
    ];
    let lights = [Light::point(Vec3::new(3.0, 5.0, 4.0), Rgb::gray(0.8))];
    let scene = Scene::new(&balls, &materials, &lights).with_ambient(Rgb::gray(0.1));
    // The first half of the balls on one side, the rest on the other: z up to 0 and beyond.
    let lattice = Lattice::new(Vec3::new(-5.0, -5.0, -5.0), 10.0);
    let step = |place: f32| ((place + 5.0) / 10.0 * 65_536.0) as u16;
    let bounds =
        |[low, high]: [f32; 2]| [[step(-4.1), step(-0.2), step(low)], [step(4.1), step(1.0), step(high)]];
    let nodes = Box::leak(Box::new([
        BvhNode::new(bounds([-2.6, 2.6]), 1, 0, 0, 2),
        BvhNode::new(bounds([-2.6, -0.4]), 0, 0, 16, 0),
        BvhNode::new(bounds([-0.6, 2.6]), 16, 0, 24, 0),
    ]));
    let tree = Bvh { lattice, nodes, count: 40, items: &[] };
    let camera = Camera::perspective(Vec3::new(1.0, 3.0, 7.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 50.0);
    let settings = Settings::new().with_depth(4);
    let draw = |scene: &Scene| film(scene, &camera, [64, 48], settings, &mut ());
    assert!(draw(&scene) == draw(&scene.with_hierarchy(&tree)));
    assert!(draw(&scene) == draw(&scene.with_hierarchy(&Every(40))));
}

static TRIANGLES: [[u16; 3]; 2] = [[0, 1, 2], [0, 2, 3]];
static PLACES: [Vec3; 4] =
    [Vec3::new(0.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0), Vec3::new(1.0, 1.0, 0.0), Vec3::new(0.0, 1.0, 0.0)];
const SQUARE: Mesh = Mesh::new(&TRIANGLES, Corners::Exact(&PLACES), Normals::Flat, &Every(2));

/// Asserts what is wrong with a mesh.
#[track_caller]
fn assert_fault(mesh: Mesh, fault: Fault) {
    let mesh: &'static Mesh = Box::leak(Box::new(mesh));
    assert_eq!(Intersect::<f32>::check(&mesh), Err(fault));
}

#[test]
fn what_is_wrong_with_a_mesh_is_named() {
    let square: &'static Mesh = Box::leak(Box::new(SQUARE));
    assert_eq!(Intersect::<f32>::check(&square), Ok(()));
    assert_fault(Mesh { corners: Corners::Exact(&PLACES[..3]), ..SQUARE }, Fault::Mesh);
    assert_fault(Mesh { normals: Normals::Exact(&PLACES[1..2]), ..SQUARE }, Fault::Mesh);
    assert_fault(Mesh { normals: Normals::Octahedral(&[[0, 0]; 3]), ..SQUARE }, Fault::Mesh);
    assert_fault(Mesh { normals: Normals::Exact(&PLACES), ..SQUARE }, Fault::NoDirection);
    assert_fault(Mesh { texture: &[[0.0, 0.0]; 3], ..SQUARE }, Fault::Mesh);
    assert_fault(Mesh { texture: &[[f32::NAN, 0.0]; 4], ..SQUARE }, Fault::OutOfRange);
    assert_fault(Mesh { hierarchy: &Every(1), ..SQUARE }, Fault::Hierarchy);
    static FAR: [Vec3; 4] = [Vec3::new(f32::INFINITY, 0.0, 0.0); 4];
    assert_fault(Mesh { corners: Corners::Exact(&FAR), ..SQUARE }, Fault::OutOfRange);
}

/// Answers what the links of a tree of three nodes over two things are judged as.
fn judge(nodes: [BvhNode; 3], items: &'static [u16]) -> Result<(), Fault> {
    let nodes = Box::leak(Box::new(nodes));
    Hierarchy::<f32>::check(&Bvh { lattice: Lattice::new(Vec3::ZERO, 1.0_f32), nodes, count: 2, items })
}

#[test]
fn links_that_lead_astray_are_refused() {
    let all = [[0; 3], [u16::MAX; 3]];
    let inner = |link: u16| BvhNode::new(all, link, 0, 0, 0);
    let leaf = |link: u16, parent: u16, items: u8| BvhNode::new(all, link, parent, items, 0);
    assert_eq!(judge([inner(1), leaf(0, 0, 1), leaf(1, 0, 1)], &[]), Ok(()));
    assert_eq!(judge([inner(1), leaf(0, 0, 1), leaf(1, 0, 1)], &[1, 0]), Ok(()));
    let astray = [
        ([inner(0), leaf(0, 0, 1), leaf(1, 0, 1)], &[][..]),
        ([inner(2), leaf(0, 0, 1), leaf(1, 0, 1)], &[]),
        ([inner(3), leaf(0, 0, 1), leaf(1, 0, 1)], &[]),
        ([inner(u16::MAX), leaf(0, 0, 1), leaf(1, 0, 1)], &[]),
        ([inner(1), leaf(0, 2, 1), leaf(1, 0, 1)], &[]),
        ([inner(1), leaf(0, 0, 1), leaf(1, 0, 2)], &[]),
        ([inner(1), leaf(0, 0, 1), leaf(1, 0, 1)], &[0]),
        ([inner(1), leaf(0, 0, 1), leaf(1, 0, 1)], &[0, 2]),
    ];
    for (nodes, items) in astray {
        assert_eq!(judge(nodes, items), Err(Fault::Hierarchy), "{nodes:?} {items:?}");
    }
}
