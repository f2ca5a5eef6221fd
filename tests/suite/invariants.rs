//! What must not change a picture, and what must change it in a known way.

use crate::support::{LIGHTS, MATERIALS, OBJECTS, ball, camera, scene, v};
use embedded_graphics::prelude::Size;
use scanray::gallery::{Gallery, View};
use scanray::ray::{Interval, Ray};
use scanray::trace::{Candidates, Observer, Packet, RayCounts, RayKind, Tracer};
use scanray::{
    Camera, Cuboid, Fixed, Light, Material, Object, Projection, Renderer, Rgb, Scene, SceneBuffer, Settings,
    Shape, Sky, Sphere, Triangle, Workspace,
};

const WIDTH: u32 = 96;
const HEIGHT: u32 = 64;

fn light_of(scene: &Scene<'_>, camera: &Camera, depth: u8) -> Vec<Rgb> {
    let mut workspace = Workspace::<f32, [u8; 2], 0, 8>::new();
    let settings = Settings::new().with_depth(depth);
    let size = Size::new(WIDTH, HEIGHT);
    let mut renderer = Renderer::new(scene, camera, size, settings, &mut workspace).unwrap();
    let mut light = Vec::new();
    for y in 0..HEIGHT {
        renderer.trace_row(y, 0..WIDTH, &mut (), |_, color| light.push(color)).unwrap();
    }
    light
}

fn apart(a: Rgb, b: Rgb) -> f32 {
    (a.r - b.r).abs().max((a.g - b.g).abs()).max((a.b - b.b).abs())
}

/// Counts the pixels of two pictures that differ by more than a rounding.
fn differing(a: &[Rgb], b: &[Rgb]) -> usize {
    a.iter().zip(b).filter(|(a, b)| apart(**a, **b) > 1e-3).count()
}

#[test]
fn the_order_of_the_objects_does_not_matter() {
    let forward = light_of(&scene(), &camera(), 3);
    let mut reversed = OBJECTS;
    reversed.reverse();
    let backward = light_of(&Scene { objects: &reversed, ..scene() }, &camera(), 3);
    assert_eq!(forward, backward);
}

/// Draws a view of the gallery, small, its objects in the order given.
fn light_of_view<S: Gallery>(view: &View<S>, objects: &[Object<S>], part: (u32, u32)) -> Vec<Rgb<S>> {
    let scene = Scene { objects, ..view.scene };
    let mut workspace = Workspace::<S, [u8; 2], 0, 8>::new();
    let size = Size::new(WIDTH, HEIGHT);
    let mut renderer = Renderer::new(&scene, &view.camera, size, view.settings, &mut workspace).unwrap();
    let mut light = Vec::new();
    for y in 0..HEIGHT {
        renderer.trace_row(y, part.0..part.1, &mut (), |_, color| light.push(color)).unwrap();
    }
    light
}

fn order_does_not_matter<S: Gallery>() {
    for view in S::views() {
        let reversed: Vec<_> = view.scene.objects.iter().rev().copied().collect();
        let pictures = [view.scene.objects, &reversed].map(|o| light_of_view(view, o, (0, WIDTH)));
        assert!(pictures[0] == pictures[1], "{}", view.name);
    }
}

#[test]
fn the_order_of_the_gallery_s_objects_does_not_matter_in_any_number() {
    order_does_not_matter::<f32>();
    order_does_not_matter::<Fixed>();
    order_does_not_matter::<f64>();
}

fn halves_make_the_whole<S: Gallery>() {
    for view in S::views() {
        let draw = |from, to| light_of_view(view, view.scene.objects, (from, to));
        let (left, right) = (draw(0, 41), draw(41, WIDTH));
        let rows = left.chunks(41).zip(right.chunks(WIDTH as usize - 41));
        let joined: Vec<_> = rows.flat_map(|(left, right)| [left, right].concat()).collect();
        assert!(joined == draw(0, WIDTH), "{}", view.name);
    }
}

#[test]
fn rows_of_the_gallery_can_be_drawn_in_parts_in_any_number() {
    halves_make_the_whole::<f32>();
    halves_make_the_whole::<Fixed>();
    halves_make_the_whole::<f64>();
}

#[test]
fn a_far_sphere_never_hides_a_near_one() {
    let (near, far) = (ball(0.0, 0.0, -3.0, 1.0, 0), ball(0.0, 0.0, -9.0, 2.0, 1));
    let materials = [Material::flat(Rgb::WHITE), Material::flat(Rgb::BLACK)];
    let ray = Ray::new(v(0.0, 0.0, 0.0), v(0.0, 0.0, -1.0));
    for objects in [[near, far], [far, near]] {
        let scene = Scene::new(&objects, &materials, &[]);
        let rays = std::iter::once((ray, Interval::AHEAD));
        let mut packet = Packet::new();
        let light =
            Tracer::new(&scene, &mut []).radiance(&mut packet, rays, Candidates::all(&scene), &mut ())[0];
        assert_eq!(light, Rgb::WHITE);
    }
}

#[test]
fn a_scene_from_flash_and_one_built_at_run_time_draw_the_same_picture() {
    let mut buffer = SceneBuffer::<f32, 4, 3, 2>::new();
    for material in MATERIALS {
        buffer.add_material(material).unwrap();
    }
    for object in OBJECTS {
        buffer.add_object(object.shape, object.material).unwrap();
    }
    for light in LIGHTS {
        buffer.add_light(light).unwrap();
    }
    let built = buffer.scene().with_ambient(scene().ambient);
    assert_eq!(light_of(&built, &camera(), 2), light_of(&scene(), &camera(), 2));
}

#[test]
fn a_row_begun_anywhere_has_the_bits_of_the_whole_row() {
    let whole = light_of(&scene(), &camera(), 2);
    let mut workspace = Workspace::<f32, [u8; 2], 0, 8>::new();
    let (size, settings) = (Size::new(WIDTH, HEIGHT), Settings::new().with_depth(2));
    let mut renderer = Renderer::new(&scene(), &camera(), size, settings, &mut workspace).unwrap();
    for y in (0..HEIGHT).step_by(5) {
        for x in 0..WIDTH {
            renderer
                .trace_row(y, x..x + 1, &mut (), |x, light| {
                    assert_eq!(light, whole[(y * WIDTH + x) as usize])
                })
                .unwrap();
        }
    }
}

/// A few objects of every shape, moved by an offset and mirrored in x by `side` = -1.
fn motley(offset: [f32; 3], side: f32) -> Vec<Object> {
    let [dx, dy, dz] = offset;
    let at = |x: f32, y: f32, z: f32| v(side * x + dx, y + dy, z + dz);
    let (near, far) = (at(0.7 * side, 0.0, 0.2), at(1.5 * side, 0.9, 1.1));
    let (near, far) = if side < 0.0 { (at(1.5, 0.0, 0.2), at(0.7, 0.9, 1.1)) } else { (near, far) };
    vec![
        Object::new(Shape::Sphere(Sphere::new(at(-0.6, 0.5, 0.0), 0.5)), 1),
        Object::new(Shape::Cuboid(Cuboid::new(near, far)), 2),
        Object::new(
            Shape::Triangle(Triangle::new(at(-3.0, 0.0, -2.0), at(3.0, 0.0, -2.5), at(0.4, 2.5, -2.2))),
            0,
        ),
    ]
}

fn sky() -> Sky {
    Sky::Gradient { up: v(0.0, 1.0, 0.0), nadir: Rgb::gray(0.2), zenith: Rgb::new(0.3, 0.5, 0.9) }
}

#[test]
fn a_scene_moved_with_its_camera_and_lights_draws_the_same_picture() {
    let picture = |dx: f32, dy: f32, dz: f32| {
        let objects = motley([dx, dy, dz], 1.0);
        let lights = [Light::point(v(3.0 + dx, 5.0 + dy, 4.0 + dz), Rgb::WHITE)];
        let scene = Scene::new(&objects, &MATERIALS, &lights).with_sky(sky());
        let (eye, center) = (v(0.5 + dx, 2.0 + dy, 6.0 + dz), v(dx, 0.8 + dy, dz));
        light_of(&scene, &Camera::perspective(eye, center, v(0.0, 1.0, 0.0), 45.0), 3)
    };
    // Sixteenths and whole numbers move without rounding; outlines may still fall on the other
    // side of a pixel's middle: 0.3 % of the pixels at most.
    let moved = differing(&picture(0.0, 0.0, 0.0), &picture(16.0, -4.0, 8.0));
    assert!(moved <= (WIDTH * HEIGHT) as usize * 3 / 1000, "{moved} pixels differ");
}

#[test]
fn the_mirror_image_of_a_scene_is_the_mirror_image_of_its_picture() {
    let picture = |side: f32| {
        let objects = motley([0.0; 3], side);
        let lights = [Light::point(v(side * 3.0, 5.0, 4.0), Rgb::WHITE)];
        let scene = Scene::new(&objects, &MATERIALS, &lights).with_sky(sky());
        let camera = Camera::perspective(v(side * 0.5, 2.0, 6.0), v(0.0, 0.8, 0.0), v(0.0, 1.0, 0.0), 45.0);
        light_of(&scene, &camera, 3)
    };
    let mut mirrored = picture(-1.0);
    mirrored.chunks_mut(WIDTH as usize).for_each(<[Rgb]>::reverse);
    let wrong = differing(&picture(1.0), &mirrored);
    assert!(wrong <= (WIDTH * HEIGHT) as usize * 3 / 1000, "{wrong} pixels differ");
    assert!(differing(&picture(1.0), &picture(-1.0)) > 500, "the scene is not symmetric itself");
}

#[test]
fn a_swapped_window_mirrors_the_picture() {
    let window = |left, right| {
        let projection = Projection::Frustum { left, right, bottom: -0.4, top: 0.4 };
        let points = [v(0.0, 2.0, 6.0), v(0.0, 0.8, 0.0), v(0.0, 1.0, 0.0)];
        light_of(&scene(), &Camera::new(points, projection, [1.0, 1000.0]), 2)
    };
    let mut swapped = window(0.6, -0.6);
    swapped.chunks_mut(WIDTH as usize).for_each(<[Rgb]>::reverse);
    assert!(differing(&window(-0.6, 0.6), &swapped) <= 20);
}

#[test]
fn a_centred_frustum_is_the_perspective_camera() {
    let half = (45_f64.to_radians() / 2.0).tan() as f32;
    let (top, right) = (half, half * WIDTH as f32 / HEIGHT as f32);
    let projection = Projection::Frustum { left: -right, right, bottom: -top, top };
    let points = [v(0.0, 2.0, 6.0), v(0.0, 0.8, 0.0), v(0.0, 1.0, 0.0)];
    let frustum = light_of(&scene(), &Camera::new(points, projection, [1.0, 1000.0]), 2);
    let perspective = light_of(&scene(), &camera().with_clip(1.0, 1000.0), 2);
    assert!(differing(&frustum, &perspective) <= 20);
}

/// Counts bounces of a ray between two mirrors that face each other.
struct Levels(u32);

impl Observer for Levels {
    fn ray(&mut self, kind: RayKind) {
        self.0 += u32::from(kind == RayKind::Reflection);
    }
}

#[test]
fn between_two_mirrors_light_bounces_as_often_as_the_depth_says() {
    let objects: [Object; 2] = [
        Object::new(Shape::Cuboid(Cuboid::new(v(-50.0, -50.0, -6.0), v(50.0, 50.0, -5.0))), 0),
        Object::new(Shape::Cuboid(Cuboid::new(v(-50.0, -50.0, 5.0), v(50.0, 50.0, 6.0))), 0),
    ];
    let materials = [Material::flat(Rgb::gray(0.25)).with_mirror(0.5)];
    let scene = Scene::new(&objects, &materials, &[]);
    let camera = Camera::perspective(v(0.0, 0.0, 0.0), v(0.0, 0.0, -1.0), v(0.0, 1.0, 0.0), 1.0);
    for depth in 0..=8_u8 {
        let mut workspace = Workspace::<f32, [u8; 2], 0, 8>::new();
        let settings = Settings::new().with_depth(depth);
        let mut renderer = Renderer::new(&scene, &camera, Size::new(1, 1), settings, &mut workspace).unwrap();
        let (mut levels, mut sum) = (Levels(0), 0.0);
        renderer.trace_row(0, 0..1, &mut levels, |_, light| sum = light.r).unwrap();
        assert_eq!(levels.0, u32::from(depth));
        // 1/4 (1 + 1/2 + 1/4 + ...): the geometric series, as far as it goes.
        let series = 0.5 - 0.25 / (1_u32 << depth) as f32;
        assert!((sum - series).abs() < 1e-6, "depth {depth}: {sum}, not {series}");
    }
}

#[test]
fn the_inside_of_a_white_ball_is_white_everywhere() {
    // Ambient light on white without lamps: the answer is exactly 1 in every pixel.
    let objects = [ball(0.0, 0.0, 0.0, 5.0, 0)];
    let materials = [Material::matte(Rgb::WHITE)];
    let scene = Scene::new(&objects, &materials, &[]).with_ambient(Rgb::WHITE);
    let camera = Camera::perspective(v(1.0, 0.5, 0.0), v(0.0, 0.0, -1.0), v(0.0, 1.0, 0.0), 90.0);
    assert!(light_of(&scene, &camera, 2).iter().all(|light| *light == Rgb::WHITE));
}

#[test]
fn a_lamp_inside_a_ball_lights_every_point_of_it() {
    let objects = [ball(0.0, 0.0, 0.0, 5.0, 0)];
    let materials = [Material::matte(Rgb::WHITE)];
    let lights = [Light::point(v(0.0, 0.0, 0.0), Rgb::WHITE)];
    let scene = Scene::new(&objects, &materials, &lights);
    let camera = Camera::perspective(v(2.0, 1.0, 0.0), v(0.0, 0.0, -1.0), v(0.0, 1.0, 0.0), 120.0);
    for light in light_of(&scene, &camera, 1) {
        assert!((light.r - 1.0).abs() < 1e-3, "a speck of {}", light.r);
    }
}

#[test]
fn nothing_outside_the_clipping_depths_is_seen() {
    let objects = [ball(0.0, 0.0, -10.0, 1.0, 0)];
    let materials = [Material::flat(Rgb::WHITE)];
    let scene = Scene::new(&objects, &materials, &[]);
    let seen = |near, far| {
        let camera = Camera::perspective(v(0.0, 0.0, 0.0), v(0.0, 0.0, -1.0), v(0.0, 1.0, 0.0), 20.0);
        light_of(&scene, &camera.with_clip(near, far), 0).iter().filter(|light| light.is_lit()).count()
    };
    let whole = seen(0.0, 100.0);
    assert!(whole > 500);
    assert_eq!(seen(8.0, 12.0), whole);
    assert_eq!(seen(0.0, 8.9), 0);
    assert_eq!(seen(11.1, 100.0), 0);
    // Cut through the middle from the front: the hollow back half is seen through the hole.
    assert_eq!(seen(9.9, 100.0), whole);
    // From the back: only the cap in front of the plane is left.
    assert!((1..whole).contains(&seen(0.0, 9.5)));
}

#[test]
fn rays_are_counted_by_what_they_are_for() {
    let mut workspace = Workspace::<f32, [u8; 2], 0, 8>::new();
    let settings = Settings::new();
    let size = Size::new(WIDTH, HEIGHT);
    let mut renderer = Renderer::new(&scene(), &camera(), size, settings, &mut workspace).unwrap();
    let mut counts = RayCounts::default();
    renderer.trace_row(40, 0..WIDTH, &mut counts, |_, _| ()).unwrap();
    assert_eq!(counts.primary, u64::from(WIDTH));
    assert!(counts.reflection > 0 && counts.reflection < counts.primary);
    assert!(counts.shadow > counts.primary);
}
