//! The z-buffer on scenes that nobody has chosen.

use embedded_graphics::prelude::Size;
use proptest::prelude::*;
use scanray::trace::{Observer, RayKind};
use scanray::{
    Camera, Cuboid, Fixed, Light, Material, Object, Plane, Projection, RasterRenderer, RasterWorkspace,
    Renderer, Rgb, Scalar, Scene, Settings, Shape, Sphere, Triangle, Vec3, Workspace,
};

const COLUMNS: u32 = 32;
const ROWS: u32 = 24;

/// Remembers the objects that are met, in the order in which they are.
#[derive(Default)]
struct Met(Vec<u16>);

impl Observer for Met {
    fn ray(&mut self, _: RayKind) {}

    fn met(&mut self, _: u8, object: u16, _: u32) {
        self.0.push(object);
    }
}

fn rasterized<S: Scalar>(scene: &Scene<'_, S>, camera: &Camera<S>) -> Vec<u16> {
    let mut workspace = RasterWorkspace::<S, { COLUMNS as usize }>::new();
    let size = Size::new(COLUMNS, ROWS);
    let Ok(mut renderer) = RasterRenderer::new(scene, camera, size, Settings::new(), &mut workspace) else {
        return vec![];
    };
    let mut met = Met::default();
    for y in 0..ROWS {
        renderer.shade_row(y, &mut met, |_, _| {}).expect("a row of the picture");
    }
    met.0
}

fn traced<S: Scalar>(scene: &Scene<'_, S>, camera: &Camera<S>) -> Vec<u16> {
    let mut workspace = Workspace::<S, [u8; 2], 0, 0>::new();
    let (size, settings) = (Size::new(COLUMNS, ROWS), Settings::new().with_depth(0));
    let Ok(mut renderer) = Renderer::new(scene, camera, size, settings, &mut workspace) else {
        return vec![];
    };
    let mut met = Met::default();
    for (x, y) in (0..ROWS).flat_map(|y| (0..COLUMNS).map(move |x| (x, y))) {
        renderer.trace_row(y, x..x + 1, &mut met, |_, _| {}).expect("a row of the picture");
    }
    met.0
}

/// Makes numbers of a kind of those that are drawn by lot.
trait Number: Scalar {
    fn of(value: f64) -> Self;
}

impl Number for f64 {
    fn of(value: f64) -> Self {
        value
    }
}

impl Number for Fixed {
    fn of(value: f64) -> Self {
        Self::new(value)
    }
}

fn vector<S: Number>(size: f64) -> impl Strategy<Value = Vec3<S>> {
    (-size..size, -size..size, -size..size).prop_map(|(x, y, z)| Vec3::new(S::of(x), S::of(y), S::of(z)))
}

fn shape<S: Number>(size: f64) -> impl Strategy<Value = Shape<S>> {
    let extent = move || vector::<S>(0.5 * size);
    prop_oneof![
        (vector(size), 0.01..0.6_f64)
            .prop_map(move |(center, share)| Shape::Sphere(Sphere::new(center, S::of(share * size)))),
        (vector(size), extent()).prop_map(|(low, extent)| {
            let up = Vec3::from_array(extent.to_array().map(Scalar::abs));
            Shape::Cuboid(Cuboid::new(low, low + up))
        }),
        (vector(size), extent(), extent()).prop_map(|(a, e, f)| Shape::Triangle(Triangle::new(
            a,
            a + e,
            a + f
        ))),
        (vector(size), vector(1.0)).prop_map(|(point, normal)| Shape::Plane(Plane::new(point, normal))),
    ]
}

fn camera<S: Number>(size: f64, near: f64) -> impl Strategy<Value = Camera<S>> {
    let projection = prop_oneof![
        (5.0..150.0).prop_map(|fovy| Projection::Perspective { fovy: S::of(fovy) }),
        (0.1..3.0).prop_map(move |share| Projection::Orthographic { height: S::of(share * size) }),
    ];
    let far = prop_oneof![Just(S::FAR), (2.0..5.0).prop_map(move |share| S::of(share * size))];
    let near = prop_oneof![Just(S::ZERO), Just(S::of(near))];
    (vector(1.2 * size), vector(size), vector(1.0), projection, near, far).prop_map(
        |(eye, center, up, projection, near, far)| Camera::new([eye, center, up], projection, [near, far]),
    )
}

fn objects_of<S: Number>(shapes: &[Shape<S>]) -> Vec<Object<S>> {
    shapes.iter().map(|shape| Object::new(*shape, 0)).collect()
}

fn materials<S: Number>() -> [Material<S>; 1] {
    [Material::matte(Rgb::WHITE)]
}

fn lights<S: Number>() -> [Light<S>; 1] {
    [Light::directional(Vec3::new(S::ONE, S::ONE, S::ZERO), Rgb::WHITE)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn each_pixel_sees_what_its_ray_meets(
        shapes in prop::collection::vec(shape::<f64>(8.0), 1..12), camera in camera::<f64>(8.0, 0.7)
    ) {
        let (objects, materials, lights) = (objects_of(&shapes), materials(), lights());
        let scene = Scene::new(&objects, &materials, &lights);
        let (traced, rasterized) = (traced(&scene, &camera), rasterized(&scene, &camera));
        prop_assume!(!traced.is_empty());
        prop_assert_eq!(traced.len(), rasterized.len());
        let wrong: Vec<usize> = (0..traced.len()).filter(|i| traced[*i] != rasterized[*i]).collect();
        prop_assert!(wrong.len() * 1000 <= 2 * traced.len(), "{} pixels differ", wrong.len());
    }

    #[test]
    fn the_order_of_the_objects_does_not_matter(
        shapes in prop::collection::vec(shape::<f64>(8.0), 1..12), camera in camera::<f64>(8.0, 0.7)
    ) {
        let (objects, materials, lights) = (objects_of(&shapes), materials(), lights());
        let reversed: Vec<Object<f64>> = objects.iter().rev().copied().collect();
        let last = objects.len() as u16 - 1;
        let there = rasterized(&Scene::new(&objects, &materials, &lights), &camera);
        let back = rasterized(&Scene::new(&reversed, &materials, &lights), &camera);
        let turned = |object: u16| last.checked_sub(object).unwrap_or(u16::MAX);
        prop_assert_eq!(there, back.into_iter().map(turned).collect::<Vec<_>>());
    }

    #[test]
    fn no_scene_in_fixed_point_makes_it_panic(
        shapes in prop::collection::vec(shape::<Fixed>(1000.0), 1..12), camera in camera::<Fixed>(800.0, 0.001)
    ) {
        let (objects, materials, lights) = (objects_of(&shapes), materials(), lights());
        let seen = rasterized(&Scene::new(&objects, &materials, &lights), &camera);
        prop_assert!(seen.is_empty() || seen.len() == (COLUMNS * ROWS) as usize);
    }

    #[test]
    fn in_fixed_point_each_pixel_sees_what_its_ray_meets(
        shapes in prop::collection::vec(shape::<Fixed>(30.0), 1..12), camera in camera::<Fixed>(30.0, 0.7)
    ) {
        let (objects, materials, lights) = (objects_of(&shapes), materials(), lights());
        let scene = Scene::new(&objects, &materials, &lights);
        // In fixed point a ray ends 2048 from the eye, a row of depths as deep into the scene: at a horizon
        // along a row the two are a row apart.
        let camera = camera.with_clip(camera.near, Ord::min(camera.far, Fixed::new(500.0)));
        let (traced, rasterized) = (traced(&scene, &camera), rasterized(&scene, &camera));
        prop_assume!(!traced.is_empty());
        prop_assert_eq!(traced.len(), rasterized.len());
        let wrong: Vec<usize> = (0..traced.len()).filter(|i| traced[*i] != rasterized[*i]).collect();
        prop_assert!(wrong.len() * 1000 <= 10 * traced.len(), "{} pixels differ", wrong.len());
    }
}
