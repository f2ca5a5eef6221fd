//! Scenes whose answer is known without any tracer, drawn by the reference.

use host_sim::reference::{self, Description, Picture, Vector};
use scanray::{
    Camera, Checker, Cone, Cuboid, FillRule, Light, Material, Object, Plane, Polygon, Projection, Rgb, Scene,
    Settings, Shape, Sky, SmoothTriangle, Sphere, Texture, Triangle, Vec3, Vertex,
};

const UP: Vec3<f64> = Vec3::new(0.0, 1.0, 0.0);
const ORIGIN: Vec3<f64> = Vec3::new(0.0, 0.0, 0.0);
const SKY: Rgb<f64> = Rgb::new(0.1, 0.2, 0.3);

fn v(x: f64, y: f64, z: f64) -> Vec3<f64> {
    Vec3::new(x, y, z)
}

fn ball(center: Vec3<f64>, radius: f64) -> Object<f64> {
    Object::new(Shape::Sphere(Sphere::new(center, radius)), 0)
}

fn pane(z: f64, material: u16) -> Object<f64> {
    Object::new(Shape::Plane(Plane::new(v(0.0, 0.0, z), v(0.0, 0.0, 3.0))), material)
}

/// Looks along -z from z = 10 through a window 2 high.
fn front() -> Camera<f64> {
    Camera::orthographic(v(0.0, 0.0, 10.0), ORIGIN, UP, 2.0)
}

fn draw(scene: &Scene<'_, f64>, camera: &Camera<f64>, depth: u8, size: [u32; 2]) -> Picture {
    let description = Description::copy(scene, camera, &Settings::new().with_depth(depth));
    reference::trace(&description.expect("all of it is known"), size, |_| {})
}

#[track_caller]
fn assert_light(found: Vector, expected: [f64; 3]) {
    let off = (0..3).map(|i| (found.0[i] - expected[i]).abs()).fold(0.0, f64::max);
    assert!(off < 1e-12, "{found:?} is not {expected:?}");
}

/// Answers the light of the one pixel in the middle.
fn middle(scene: &Scene<'_, f64>, camera: &Camera<f64>, depth: u8) -> Vector {
    draw(scene, camera, depth, [1, 1]).light[0]
}

#[test]
fn a_ball_seen_head_on_has_the_light_computed_by_hand() {
    let shiny = Material::matte(Rgb::new(0.5, 0.4, 0.2)).with_specular(Rgb::new(0.3, 0.6, 0.9), 2);
    // 60 degrees from the normal, so n.L = 1/2, and (r.v)^2 = 1/4.
    let light = Light::directional(v(3.0_f64.sqrt(), 0.0, 1.0), Rgb::new(2.0, 1.0, 0.5));
    let (objects, materials, lights) = ([ball(ORIGIN, 1.0)], [shiny.with_ambient(0.5)], [light]);
    let scene = Scene::new(&objects, &materials, &lights).with_ambient(Rgb::new(0.2, 0.2, 0.4));
    let expected = [0.05 + 2.0 * (0.25 + 0.075), 0.04 + 0.2 + 0.15, 0.04 + 0.5 * (0.1 + 0.225)];
    assert_light(middle(&scene, &front(), 0), expected);
    let pinhole = Camera::perspective(v(0.0, 0.0, 10.0), ORIGIN, UP, 30.0);
    assert_light(middle(&scene, &pinhole, 0), expected);
}

#[test]
fn a_light_behind_the_surface_or_behind_another_thing_leaves_the_ambient_light() {
    let materials = [Material::matte(Rgb::gray(0.5)).with_specular(Rgb::WHITE, 1)];
    let light = Light::point(v(4.0, 0.0, 5.0), Rgb::WHITE);
    let behind = [Light::point(v(4.0, 0.0, 0.5), Rgb::WHITE)];
    let objects = [ball(ORIGIN, 1.0), ball(v(2.0, 0.0, 3.0), 0.5)];
    let ambient = Rgb::gray(0.2);
    let dark = Scene::new(&objects[..1], &materials, &behind).with_ambient(ambient);
    assert_light(middle(&dark, &front(), 0), [0.1; 3]);
    let lights = [light];
    let shadowed = Scene::new(&objects, &materials, &lights).with_ambient(ambient);
    assert_light(middle(&shadowed, &front(), 0), [0.1; 3]);
    // Beyond the light nothing blocks it: 45 degrees.
    let beyond = [ball(ORIGIN, 1.0), ball(v(6.0, 0.0, 7.0), 0.5)];
    let lit = Scene::new(&beyond, &materials, &lights);
    let half = 0.5_f64.sqrt();
    assert_light(middle(&lit, &front(), 0), [0.5 * half + half; 3]);
}

#[test]
fn two_facing_mirrors_sum_the_geometric_series_of_their_depth() {
    let materials = [Material::matte(Rgb::gray(0.5)).with_mirror(0.5)];
    let objects = [pane(0.0, 0), pane(20.0, 0)];
    let scene = Scene::new(&objects, &materials, &[]).with_ambient(Rgb::WHITE);
    for depth in 0..6 {
        // 1/2 + 1/4 + ... : depth + 1 terms.
        let sum = 1.0 - 0.5_f64.powi(i32::from(depth) + 1);
        assert_light(middle(&scene, &front(), depth), [sum; 3]);
    }
}

#[test]
fn from_inside_a_white_ball_everything_is_white_and_shadow_free() {
    let materials = [Material::matte(Rgb::WHITE)];
    let (objects, lights) = ([ball(ORIGIN, 4.0)], [Light::point(ORIGIN, Rgb::gray(0.5))]);
    let scene = Scene::new(&objects, &materials, &lights);
    // The light is in the middle: it stands above every point of the wall.
    let camera = Camera::perspective(v(1.0, 2.0, -0.5), v(0.0, 0.3, 0.0), v(1.0, 1.0, 0.0), 120.0);
    draw(&scene, &camera, 0, [8, 6]).light.iter().for_each(|light| assert_light(*light, [0.5; 3]));
}

#[test]
fn near_and_far_planes_cut_things_open_and_away() {
    let materials = [Material::flat(Rgb::gray(0.4)), Material::flat(Rgb::gray(0.8))];
    let objects = [ball(ORIGIN, 2.0), pane(-5.0, 1)];
    let scene = Scene::new(&objects, &materials, &[]).with_sky(Sky::Solid(SKY));
    let seen = |near, far| middle(&scene, &front().with_clip(near, far), 0);
    assert_light(seen(7.0, 16.0), [0.4; 3]);
    // Behind the front of the ball its back is seen, behind that the plane.
    assert_light(seen(9.0, 16.0), [0.4; 3]);
    assert_light(seen(12.0, 16.0), [0.8; 3]);
    assert_light(seen(12.0, 15.0), [0.1, 0.2, 0.3]);
    let trail = &draw(&scene, &front().with_clip(15.0, 99.0), 0, [1, 1]).trails[0];
    assert!(trail.is_empty(), "a hit on the plane itself does not count");
}

#[test]
fn the_depth_of_a_pinhole_is_measured_along_the_line_of_sight() {
    let materials = [Material::flat(Rgb::WHITE)];
    let objects = [pane(0.0, 0)];
    let scene = Scene::new(&objects, &materials, &[]);
    let camera = Camera::perspective(v(0.0, 0.0, 10.0), ORIGIN, UP, 120.0);
    // The corner of the wall is 20 and more away, but all of it 10 deep.
    let all = draw(&scene, &camera.with_clip(9.9, 10.1), 0, [9, 9]);
    assert!(all.light.iter().all(|light| light.0 == [1.0; 3]));
    let none = draw(&scene, &camera.with_clip(10.1, 99.0), 0, [9, 9]);
    assert!(none.light.iter().all(|light| light.0 == [0.0; 3]));
}

#[test]
fn the_top_row_is_up_and_the_first_column_left() {
    let materials = [Material::flat(Rgb::WHITE)];
    let corners = [v(-1.0, 1.0, 0.0), v(-1.0, -0.2, 0.0), v(0.2, 1.0, 0.0)];
    let objects = [Object::new(Shape::Triangle(Triangle::new(corners[0], corners[1], corners[2])), 0)];
    let scene = Scene::new(&objects, &materials, &[]);
    for camera in [front(), Camera::perspective(v(0.0, 0.0, 1.0), ORIGIN, UP, 90.0)] {
        assert_eq!(reds(&scene, &camera), [1.0, 0.0, 0.0, 0.0]);
    }
}

/// Answers the red light of a picture of two by two pixels.
fn reds(scene: &Scene<'_, f64>, camera: &Camera<f64>) -> Vec<f64> {
    draw(scene, camera, 0, [2, 2]).light.iter().map(|light| light.0[0]).collect()
}

#[test]
fn tiles_lie_on_planes_boxes_and_triangles_where_their_coordinates_say() {
    let board =
        |per_unit| Material::textured(Texture::Checker(Checker::new(Rgb::BLACK, Rgb::WHITE, per_unit)));
    let look = |shape: Shape<f64>, per_unit: f64| {
        let (objects, materials) = ([Object::new(shape, 0)], [board(per_unit)]);
        reds(&Scene::new(&objects, &materials, &[]).with_ambient(Rgb::WHITE), &front())
    };
    let quadrants = [1.0, 0.0, 0.0, 1.0];
    assert_eq!(look(Shape::Plane(Plane::new(ORIGIN, v(0.0, 0.1, 0.5))), 1.0), quadrants);
    // A box without thickness; its side of 2 is the unit of its coordinates.
    let rectangle = Cuboid::new(v(-1.0, -1.0, -1.0), v(1.0, 1.0, -1.0));
    assert_eq!(look(Shape::Cuboid(rectangle), 2.0), quadrants);
    // The sides of 10 are the units: a tile is as wide as a pixel.
    let triangle = Triangle::new(v(-1.0, -1.0, 0.0), v(9.0, -1.0, 0.0), v(-1.0, 9.0, 0.0));
    assert_eq!(look(Shape::Triangle(triangle), 10.0), quadrants);
}

/// Answers the red light in the middle of a row of four pixels a unit wide, seen along z.
fn row(shape: Shape<f64>) -> Vec<f64> {
    let materials = [Material::matte(Rgb::WHITE)];
    let (objects, lights) = ([Object::new(shape, 0)], [Light::directional(v(0.0, 0.0, 1.0), Rgb::WHITE)]);
    let scene = Scene::new(&objects, &materials, &lights);
    let camera = Camera::orthographic(v(0.0, 0.0, 10.0), ORIGIN, UP, 1.0);
    draw(&scene, &camera, 0, [4, 1]).light.iter().map(|light| light.0[0]).collect()
}

#[track_caller]
fn assert_row(shape: Shape<f64>, expected: [f64; 4]) {
    let found = row(shape);
    let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off < 1e-12, "{found:?} is not {expected:?}");
}

#[test]
fn cones_and_cylinders_have_the_light_computed_by_hand_inside_and_outside() {
    let cosine = |x: f64| (1.0 - x * x).sqrt();
    // Across: the light of a circle. Along: a cap, or nothing, and the inside of a funnel.
    let across = Cone::cylinder(v(0.0, -3.0, 0.0), v(0.0, 3.0, 0.0), 1.0);
    assert_row(Shape::Cone(across), [0.0, cosine(0.5), cosine(0.5), 0.0]);
    assert_row(Shape::Cone(across.open()), [0.0, cosine(0.5), cosine(0.5), 0.0]);
    let along = Cone::cylinder(v(0.0, 0.0, -3.0), v(0.0, 0.0, 3.0), 1.0);
    assert_row(Shape::Cone(along), [0.0, 1.0, 1.0, 0.0]);
    assert_row(Shape::Cone(along.open()), [0.0; 4]);
    // Its side rises by 4 over 3 outward.
    let funnel = Cone::new(v(0.0, 0.0, 0.0), 0.0, v(0.0, 0.0, 4.0), 3.0);
    assert_row(Shape::Cone(funnel.open()), [0.6; 4]);
    assert_row(Shape::Cone(funnel), [1.0; 4]);
}

#[test]
fn polygons_hold_what_their_rule_says() {
    // Around the middle two pixels twice, around the left one once.
    static SPIRAL: [Vec3<f64>; 8] = [
        Vec3::new(-2.0, -1.0, 0.0),
        Vec3::new(1.0, -1.0, 0.0),
        Vec3::new(1.0, 1.0, 0.0),
        Vec3::new(-2.0, 1.0, 0.0),
        Vec3::new(-1.0, -0.8, 0.0),
        Vec3::new(0.9, -0.8, 0.0),
        Vec3::new(0.9, 0.8, 0.0),
        Vec3::new(-1.2, 0.8, 0.0),
    ];
    let polygon = |rule| Shape::Polygon(Polygon::new(&SPIRAL, v(0.0, 0.0, -2.0), rule));
    assert_row(polygon(FillRule::Winding), [1.0, 1.0, 1.0, 0.0]);
    assert_row(polygon(FillRule::OddEven), [1.0, 0.0, 0.0, 0.0]);
}

#[test]
fn a_smooth_triangle_is_lit_by_the_mixed_normals_of_its_corners() {
    const FLAT: Vec3<f64> = Vec3::new(0.0, 0.0, 1.0);
    static CORNERS: [Vertex<f64>; 3] = [
        Vertex::new(Vec3::new(-2.0, -1.0, 0.0), FLAT, [0.0, 0.0]),
        Vertex::new(Vec3::new(2.0, -1.0, 0.0), Vec3::new(0.8, 0.0, 0.6), [1.0, 0.0]),
        Vertex::new(Vec3::new(-2.0, 9.0, 0.0), FLAT, [0.0, 1.0]),
    ];
    let light = |x: f64| {
        let share = (x + 2.0) / 4.0;
        let (aside, toward) = (0.8 * share, 1.0 - 0.4 * share);
        toward / toward.hypot(aside)
    };
    assert_row(
        Shape::SmoothTriangle(SmoothTriangle::new(&CORNERS)),
        [light(-1.5), light(-0.5), light(0.5), light(1.5)],
    );
}

#[test]
fn a_frustum_with_a_window_in_the_middle_is_a_pinhole() {
    let materials = [Material::matte(Rgb::gray(0.5)).with_mirror(0.5)];
    let objects = [ball(ORIGIN, 2.0), ball(v(2.0, 1.0, 3.0), 1.0)];
    let lights = [Light::point(v(9.0, 9.0, 9.0), Rgb::WHITE)];
    let scene = Scene::new(&objects, &materials, &lights).with_sky(Sky::Solid(SKY));
    let points = [v(3.0, 4.0, 10.0), ORIGIN, v(0.3, 1.0, 0.0)];
    let [eye, center, up] = points;
    // 2 atan(1/2) degrees at near 2: one up and one down.
    let pinhole = Camera::perspective(eye, center, up, 2.0 * 0.5_f64.atan().to_degrees());
    let window = Projection::Frustum { left: -2.0, right: 2.0, bottom: -1.0, top: 1.0 };
    let frustum = Camera::new(points, window, [2.0, 1e18]);
    let [a, b] = [pinhole, frustum].map(|camera| draw(&scene, &camera, 2, [20, 10]).light);
    a.iter().zip(&b).for_each(|(a, b)| assert_light(*a, b.0));
}

#[test]
fn the_mirror_of_a_scene_draws_the_mirror_of_its_picture() {
    let flip = |p: Vec3<f64>, sign: f64| v(sign * p.x, p.y, p.z);
    let draw = |sign: f64| {
        let sphere = ball(flip(v(1.0, 0.5, 0.0), sign), 1.2);
        let corners = [v(-2.0, -1.0, 1.0), v(0.0, 2.0, -1.0), v(-3.0, 1.0, -2.0)].map(|p| flip(p, sign));
        let triangle = Object::new(Shape::Triangle(Triangle::new(corners[0], corners[1], corners[2])), 1);
        let objects = [sphere, triangle, pane(-3.0, 1)];
        let shiny = Material::matte(Rgb::new(0.2, 0.4, 0.6)).with_specular(Rgb::gray(0.5), 20);
        let materials = [shiny.with_mirror(0.6), shiny];
        let lights = [Light::point(flip(v(5.0, 7.0, 9.0), sign), Rgb::WHITE)];
        let scene = Scene::new(&objects, &materials, &lights).with_sky(Sky::Solid(SKY));
        let eye = flip(v(1.0, 2.0, 8.0), sign);
        draw(&scene, &Camera::perspective(eye, flip(v(0.2, 0.0, 0.0), sign), UP, 50.0), 3, [24, 18])
    };
    let (plain, flipped) = (draw(1.0), draw(-1.0));
    for (row, mirrored) in plain.light.chunks(24).zip(flipped.light.chunks(24)) {
        row.iter().zip(mirrored.iter().rev()).for_each(|(a, b)| assert_light(*a, b.0));
    }
    let masks = [plain.silhouettes(), flipped.silhouettes()].map(|m| m.iter().filter(|m| **m).count());
    assert_eq!(masks[0], masks[1]);
    assert!(masks[0] > 0);
}
