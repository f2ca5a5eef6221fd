//! Bumps and reliefs give the known answers, in every number.

use crate::support::picture::{NIGHT, ball, differing, draw};
use crate::support::v;
use embedded_graphics::image::ImageRaw;
use embedded_graphics::pixelcolor::{Gray8, Rgb888};
use embedded_graphics::prelude::Size;
use scanray::math::Scalar;
use scanray::ray::{Interval, Ray};
use scanray::{
    Bitmap, Bump, Camera, Displaced, Fixed, Image, Intersect, Light, Material, Object, Plane, Renderer, Rgb,
    Scene, Settings, Shape, Sphere, Vec3, Workspace,
};

/// Runs the same check in every number.
macro_rules! in_every_number {
    ($check:ident) => {
        $check::<f32>(|x| x as f32, f64::from);
        $check::<Fixed>(Fixed::new, Fixed::to_f64);
        $check::<f64>(|x| x, |x| x);
    };
}

static LEVEL: ImageRaw<Gray8> = ImageRaw::new(&[102; 4], 2);
#[test]
fn bumps_without_slope_change_nothing() {
    static FACING: ImageRaw<Rgb888> = ImageRaw::new(&[127, 128, 255, 128, 127, 255], 2);
    let plain = Material::matte(Rgb::WHITE).with_specular(Rgb::gray(0.5), 20);
    let floor = Shape::Plane(Plane::new(v(0.0, -1.0, 0.0), v(0.0, 1.0, 0.0)));
    let objects = [Object::new(ball(1.0), 0), Object::new(floor, 0)];
    let without = draw(&objects, &[plain], NIGHT);
    let level = plain.with_bump(Bump::heights(Image::new(Bitmap::new(&LEVEL)), 0.5));
    assert_eq!(differing(&draw(&objects, &[level], NIGHT), &without, 1e-5), 0);
    let facing = plain.with_bump(Bump::normals(Image::new(Bitmap::new(&FACING))));
    assert_eq!(differing(&draw(&objects, &[facing], NIGHT), &without, 0.02), 0);
}

/// Is a slope of a hundred levels to the right from one column to the next.
static SLOPE: ImageRaw<Gray8> = ImageRaw::new(&[0, 100, 200, 0, 100, 200, 0, 100, 200], 3);

#[test]
fn a_slope_is_lit_as_the_inclined_plane_is() {
    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        // 3 high in 3: two texels of a hundred levels are two units wide.
        let bump =
            Bump::heights(Image::new(Bitmap::new(&SLOPE)).with_tiles(make(0.5), make(0.5)), make(2.55));
        let materials = [Material::matte(Rgb::WHITE).with_bump(bump)];
        let o = Vec3::ZERO;
        let wall = Plane::new(o, Vec3::new(S::ZERO, S::ZERO, S::ONE));
        let objects = [Object::new(Shape::Plane(wall), 0)];
        // At 45 degrees from the left the slope of 45 degrees is met head on.
        let lights = [Light::directional(Vec3::new(-S::ONE, S::ZERO, S::ONE), Rgb::WHITE)];
        let scene = Scene::<S>::new(&objects, &materials, &lights);
        let camera = Camera::orthographic(
            Vec3::new(S::ONE, S::ONE, make(5.0)),
            Vec3::new(S::ONE, S::ONE, S::ZERO),
            Vec3::new(S::ZERO, S::ONE, S::ZERO),
            make(0.5),
        );
        let mut workspace = Workspace::<S, [u8; 2], 0, 0>::new();
        let settings = Settings::new().with_depth(0);
        let mut renderer = Renderer::new(&scene, &camera, Size::new(8, 8), settings, &mut workspace).unwrap();
        for y in 0..8 {
            renderer
                .trace_row(y, 0..8, &mut (), |_, light| {
                    assert!((read(light.r) - 1.0).abs() < 1e-5, "{light:?}")
                })
                .unwrap();
        }
    }
    in_every_number!(check);
}

#[test]
fn a_ball_with_a_level_relief_is_the_larger_ball() {
    let materials = [Material::matte(Rgb::WHITE), Material::matte(Rgb::gray(0.7))];
    let floor = Object::new(Shape::Plane(Plane::new(v(0.0, -1.3, 0.0), v(0.0, 1.0, 0.0))), 1);
    let inner = Sphere::new(v(0.0, 0.0, 0.0), 0.8);
    // 102 is two fifths of 255.
    let relief = Shape::Displaced(Displaced::new(inner, Image::new(Bitmap::new(&LEVEL)), 0.5));
    let larger = draw(&[Object::new(ball(1.0), 0), floor], &materials, NIGHT);
    let moved = draw(&[Object::new(relief, 0), floor], &materials, NIGHT);
    assert!(differing(&moved, &larger, 0.01) <= 27, "one in a hundred pixels, beside edges");
    let smaller = draw(&[Object::new(ball(0.8), 0), floor], &materials, NIGHT);
    assert!(differing(&moved, &smaller, 0.01) > 200);
}

#[test]
fn from_inside_a_relief_its_far_side_is_met() {
    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        // 102 is two fifths of 255: everywhere the surface is 1 from the middle.
        let ball = Sphere::new(Vec3::ZERO, make(0.8));
        let moved = Displaced::new(ball, Image::new(Bitmap::new(&LEVEL)), S::HALF);
        let ray = Ray::new(Vec3::new(make(0.9), S::ZERO, S::ZERO), Vec3::new(-S::ONE, S::ZERO, S::ZERO));
        let crossing = moved.intersect(&ray, &Interval::AHEAD).expect("the far side");
        let t = read(crossing.t);
        assert!((t - 1.9).abs() < 2e-5, "met after {t}");
        let normal = moved.surface(&ray, &crossing).normal;
        assert!((read(normal.x) + 1.0).abs() < 1e-4, "outward: {normal:?}");
        assert!(moved.occludes(&ray, &Interval::AHEAD));
        assert!(!moved.occludes(&ray, &Interval::new(S::ZERO, S::ONE)));
    }
    in_every_number!(check);
}

#[test]
fn a_relief_moves_the_points_that_rays_meet() {
    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        // Around the equator 0, 100, 200 and back to 0; the seam is at +x.
        let ball = Sphere::new(Vec3::ZERO, S::ONE);
        let moved = Displaced::new(ball, Image::new(Bitmap::new(&SLOPE)), make(0.51));
        let distance = |x: f64, z: f64| {
            let (direction, _) = Vec3::new(make(-x), S::ZERO, make(-z)).normalize().expect("a direction");
            let ray = Ray::new(Vec3::new(make(4.0 * x), S::ZERO, make(4.0 * z)), direction);
            let crossing = moved.intersect(&ray, &Interval::AHEAD).expect("a hit");
            (read(crossing.t), read(moved.surface(&ray, &crossing).point.length()))
        };
        // u = 1/2 is the middle column; u = 1/4 and 3/4 lie halfway to its neighbours.
        for ((x, z), radius) in [((-1.0, 0.0), 1.2), ((0.0, -1.0), 1.1), ((0.0, 1.0), 1.3)] {
            let (t, on_surface) = distance(x, z);
            assert!(
                (t - (4.0 - radius)).abs() < 2e-5 && (on_surface - radius).abs() < 2e-5,
                "{t}, {on_surface}"
            );
        }
    }
    in_every_number!(check);
}
