//! The objects left out of a pixel are objects that its ray does not meet.

use embedded_graphics::prelude::Size;
use proptest::prelude::*;
use scanray::render::Spans;
use scanray::trace::{Candidates, Packet, Pending, Tracer};
use scanray::{
    Camera, Cuboid, Glass, Light, Material, Object, Plane, Projection, Renderer, Rgb, Scene, Settings, Shape,
    Sky, Sphere, Triangle, Vec3, Workspace,
};

const COLUMNS: u32 = 24;
const ROWS: u32 = 18;

fn vector(size: f32) -> impl Strategy<Value = Vec3> {
    (-size..size, -size..size, -size..size).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn shape() -> impl Strategy<Value = Shape> {
    prop_oneof![
        (vector(8.0), 0.05_f32..5.0).prop_map(|(c, r)| Shape::Sphere(Sphere::new(c, r))),
        (vector(8.0), vector(2.0)).prop_map(|(a, e)| {
            Shape::Cuboid(Cuboid::new(a, a + Vec3::new(e.x.abs(), e.y.abs(), e.z.abs() + 0.1)))
        }),
        (vector(8.0), vector(4.0), vector(4.0)).prop_map(|(a, e, f)| Shape::Triangle(Triangle::new(
            a,
            a + e,
            a + f
        ))),
        (vector(8.0), vector(1.0)).prop_map(|(p, n)| Shape::Plane(Plane::new(p, n))),
    ]
}

fn camera() -> impl Strategy<Value = Camera> {
    let projection = prop_oneof![
        (5.0_f32..150.0).prop_map(|fovy| Projection::Perspective { fovy }),
        (0.5_f32..20.0).prop_map(|height| Projection::Orthographic { height }),
        (-3.0_f32..3.0, 0.1_f32..3.0, -3.0_f32..3.0, 0.1_f32..3.0).prop_map(|(left, w, bottom, h)| {
            Projection::Frustum { left, right: left + w, bottom, top: bottom + h }
        }),
    ];
    (vector(10.0), vector(10.0), vector(1.0), projection)
        .prop_map(|(eye, center, up, projection)| Camera::new([eye, center, up], projection, [0.5, 100.0]))
}

fn spot() -> impl Strategy<Value = Light> {
    (vector(12.0), vector(8.0), 0.0_f32..0.95, 0_u16..20)
        .prop_map(|(place, axis, cutoff, falloff)| Light::spot(place, axis, cutoff, falloff, Rgb::gray(0.5)))
}

/// Answers a material that tells the object apart: one that light shows, clear glass, a mirror.
fn material(i: u16, shape: &Shape) -> Material {
    let color = Rgb::new(f32::from(i), 1.0, 0.0);
    let has_inside = !matches!(shape, Shape::Triangle(_));
    match i % 3 {
        0 => Material::matte(color).with_specular(Rgb::WHITE, 20),
        1 if has_inside => Material::flat(color).with_mirror(0.25).with_glass(Glass::new(0.5, 1.5)),
        _ => Material::flat(color).with_mirror(0.5),
    }
}

fn scene_of<'a>(objects: &'a [Object], materials: &'a [Material]) -> Scene<'a> {
    Scene::new(objects, materials, &[]).with_sky(Sky::Solid(Rgb::gray(0.5)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn culling_by_rows_never_changes_a_picture(
        shapes in prop::collection::vec(shape(), 1..48),
        lights in prop::collection::vec(spot(), 0..3),
        camera in camera(),
    ) {
        let materials: Vec<Material> = (0..).zip(&shapes).map(|(i, shape)| material(i, shape)).collect();
        let objects: Vec<Object> = (0..).zip(&shapes).map(|(i, shape)| Object::new(*shape, i)).collect();
        let scene = Scene { lights: &lights, ..scene_of(&objects, &materials) };
        prop_assume!(scene.check().is_ok());
        let Ok(frame) = camera.frame(COLUMNS, ROWS) else { return Ok(()) };
        let mut workspace = Workspace::<f32, [u8; 2], 0, 2>::new();
        let settings = Settings::new().with_depth(2);
        let size = Size::new(COLUMNS, ROWS);
        let mut renderer = Renderer::new(&scene, &camera, size, settings, &mut workspace).expect("checked above");
        for y in 0..ROWS {
            let mut culled = Vec::new();
            renderer.trace_row(y, 0..COLUMNS, &mut (), |_, light| culled.push(light)).expect("a row of the picture");
            let mut pending = [Pending::NONE; 2];
            let mut tracer = Tracer::new(&scene, &mut pending);
            let mut packet = Packet::new();
            let brute = frame.row(y, 0).take(COLUMNS as usize).map(|found| {
                let ray = std::iter::once((found.ray, found.interval));
                tracer.radiance(&mut packet, ray, Candidates::all(&scene), &mut ())[0]
            });
            prop_assert_eq!(culled, brute.collect::<Vec<_>>());
        }
    }
}

#[test]
fn rows_leave_out_what_they_cannot_touch_and_keep_the_order() {
    let ball = |y: f32| Object::new(Shape::Sphere(Sphere::new(Vec3::new(0.0, y, -10.0), 0.5)), 0);
    let behind = Object::new(Shape::Sphere(Sphere::new(Vec3::new(0.0, 0.0, 10.0), 0.5)), 0);
    let objects = [ball(3.0), behind, ball(0.0), ball(-3.0), ball(0.2)];
    let materials = [Material::flat(Rgb::WHITE)];
    let scene = scene_of(&objects, &materials);
    let origin = Vec3::new(0.0, 0.0, 0.0);
    let camera = Camera::perspective(origin, Vec3::new(0.0, 0.0, -1.0), Vec3::new(0.0, 1.0, 0.0), 60.0);
    let frame = camera.frame(100, 100).expect("a good camera");
    let mut spans = Spans::new();
    spans.enter_picture(&scene, &frame);
    let mut of_row = |y| {
        spans.enter_row(&scene, &frame, y);
        spans.enter_column(50);
        spans.candidates().named.to_vec()
    };
    assert_eq!(of_row(50), [2, 4]);
    assert_eq!(of_row(24), [0]);
    assert_eq!(of_row(99), [] as [u16; 0]);
}

#[test]
fn more_objects_than_the_list_has_room_for_are_all_kept() {
    let ball = |x: i16| {
        Object::new(Shape::Sphere(Sphere::new(Vec3::new(0.4 * f32::from(x) - 20.0, 0.0, -50.0), 0.6)), 0)
    };
    let objects: Vec<Object> = (0..100).map(ball).collect();
    let materials = [Material::flat(Rgb::WHITE)];
    let scene = scene_of(&objects, &materials);
    let origin = Vec3::new(0.0, 0.0, 0.0);
    let camera = Camera::perspective(origin, Vec3::new(0.0, 0.0, -1.0), Vec3::new(0.0, 1.0, 0.0), 60.0);
    let frame = camera.frame(100, 101).expect("a good camera");
    let mut spans = Spans::new();
    spans.enter_picture(&scene, &frame);
    spans.enter_row(&scene, &frame, 50);
    let mut seen = std::collections::BTreeSet::new();
    for x in 0..100 {
        spans.enter_column(x);
        let Candidates { named, rest } = spans.candidates();
        seen.extend(named.iter().copied().chain(rest));
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), (0..100).collect::<Vec<_>>());
}
