//! Textures give the known answers, in every number.

use crate::support::picture::{NIGHT, ball, draw};
use embedded_graphics::image::ImageRaw;
use embedded_graphics::pixelcolor::Rgb888;
use scanray::hit::Surface;
use scanray::math::Scalar;
use scanray::ray::{Interval, Ray};
use scanray::{
    Bitmap, Cone, Cuboid, Filter, Fixed, Image, Intersect, Material, Model, Object, Plane, Procedural, Rgb,
    SmoothTriangle, Sphere, Texture, Triangle, Vec3, Vertex,
};

/// Is red, green and blue from left to right, above white, grey and black.
static FLAG: ImageRaw<Rgb888> =
    ImageRaw::new(&[255, 0, 0, 0, 255, 0, 0, 0, 255, /* below */ 255, 255, 255, 188, 188, 188, 0, 0, 0], 3);
const ABOVE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// Is the light of level 188.
const GREY: f64 = 0.502_886_458_032_568_7;

fn assert_color<S: Scalar>(found: Rgb<S>, expected: [f64; 3], read: fn(S) -> f64) {
    for (found, expected) in [found.r, found.g, found.b].map(read).into_iter().zip(expected) {
        assert!((found - expected).abs() < 3e-6, "{found} instead of {expected}");
    }
}

/// Runs the same check in every number.
macro_rules! in_every_number {
    ($check:ident) => {
        $check::<f32>(|x| x as f32, f64::from);
        $check::<Fixed>(Fixed::new, Fixed::to_f64);
        $check::<f64>(|x| x, |x| x);
    };
}

#[test]
fn an_image_runs_from_the_left_rim_to_the_right_and_from_the_bottom_up() {
    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let image = Image::<S>::new(Bitmap::new(&FLAG));
        for filter in [Filter::Nearest, Filter::Bilinear] {
            let image = image.with_filter(filter);
            let at = |u: f64, v: f64| image.color(make(u), make(v));
            let top = 1.0 - 1.0 / 1_048_576.0;
            assert_color(at(0.0, top), ABOVE[0], read);
            assert_color(at(0.5, top), ABOVE[1], read);
            assert_color(at(top, top), ABOVE[2], read);
            assert_color(at(0.0, 0.0), [1.0; 3], read);
            assert_color(at(0.5, 0.0), [GREY; 3], read);
        }
    }
    in_every_number!(check);
}

#[test]
fn between_texels_light_is_mixed_or_that_of_the_nearest() {
    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let smooth = Image::<S>::new(Bitmap::new(&FLAG));
        let color = |u: f64, v: f64| smooth.color(make(u), make(v));
        assert_color(color(0.25, 0.0), [(1.0 + GREY) / 2.0; 3], read);
        let between = [(0.75 + 0.25 * GREY) * 0.5 + 0.375, (0.75 + 0.25 * GREY) * 0.5 + 0.125];
        assert_color(color(0.125, 0.5), [between[0], between[1], (0.75 + 0.25 * GREY) * 0.5], read);
        let sharp = smooth.with_filter(Filter::Nearest);
        assert_color(sharp.color(make(0.24), make(0.4)), [1.0; 3], read);
        assert_color(sharp.color(make(0.26), make(0.4)), [GREY; 3], read);
        assert_color(sharp.color(make(0.26), make(0.6)), ABOVE[1], read);
    }
    in_every_number!(check);
}

#[test]
fn an_image_is_repeated_and_below_zero_mirrored() {
    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let image = Image::<S>::new(Bitmap::new(&FLAG)).with_tiles(make(0.5), make(-0.25));
        for (u, v) in [(0.0, -2.0), (2.0, -2.0), (-600.0, 402.0), (600.0, -1002.0)] {
            for (right, up) in [(0.25, 0.125), (0.75, 0.5), (1.5, -0.75)] {
                let there = image.color(make(u + right), make(v + up));
                let here = image.color(make(right), make(-2.0 + up));
                assert_eq!(there, here);
            }
        }
        // Up the wall the mirrored image runs down.
        assert_color(image.color(make(0.0), make(1.0 / 262_144.0)), ABOVE[0], read);
    }
    in_every_number!(check);
}

/// Answers the texture coordinates where a ray from a point toward another meets a shape.
fn coordinates<S: Scalar>(
    make: fn(f64) -> S,
    read: fn(S) -> f64,
    shape: &impl Intersect<S>,
    from: [f64; 3],
    to: [f64; 3],
) -> [f64; 2] {
    let point = |p: [f64; 3]| Vec3::from_array(p.map(make));
    let (direction, _) = (point(to) - point(from)).normalize().expect("two points");
    let ray = Ray::new(point(from), direction);
    let crossing = shape.intersect(&ray, &Interval::AHEAD).expect("a hit");
    shape.texture_coordinates(&shape.surface(&ray, &crossing)).map(read)
}

#[test]
fn the_world_lies_on_a_ball_with_its_north_up_and_its_east_to_the_right() {
    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let center = [2.0, -1.0, 0.5];
        let ball = Sphere::new(Vec3::from_array(center.map(make)), make(1.5));
        let seen_from = |x: f64, y: f64, z: f64| {
            let from = [center[0] + 9.0 * x, center[1] + 9.0 * y, center[2] + 9.0 * z];
            coordinates(make, read, &ball, from, center)
        };
        let half = 0.5_f64.sqrt();
        // Round the ball eastward: +z, +x north-east of it, ...
        for (place, [u, v]) in [
            (seen_from(0.0, 0.0, 1.0), [0.75, 0.5]),
            (seen_from(half, 0.0, half), [0.875, 0.5]),
            (seen_from(0.0, 0.0, -1.0), [0.25, 0.5]),
            (seen_from(-1.0, 0.0, 0.0), [0.5, 0.5]),
            (seen_from(0.0, half, half), [0.75, 0.75]),
            (seen_from(0.0, -half, -half), [0.25, 0.25]),
        ] {
            assert!((place[0] - u).abs() < 1e-5 && (place[1] - v).abs() < 1e-5, "{place:?}, not {u}, {v}");
        }
        assert!(seen_from(0.0, 1.0, 0.0)[1] > 0.999_99 && seen_from(0.0, -1.0, 0.0)[1] < 1e-5);
    }
    in_every_number!(check);
}

#[test]
fn tangents_are_the_ways_the_coordinates_grow() {
    fn check(shape: &impl Intersect<f64>, from: Vec3<f64>, to: Vec3<f64>) {
        let look = |to: Vec3<f64>| {
            let ray = Ray::new(from, (to - from).normalize().expect("two points").0);
            let surface = shape.surface(&ray, &shape.intersect(&ray, &Interval::AHEAD).expect("a hit"));
            (surface, shape.texture_coordinates(&surface))
        };
        let (surface, _) = look(to);
        // A smooth triangle is lit beside where it is met.
        let (_, here) = look(surface.point);
        for (along, tangent) in shape.tangents(&surface).into_iter().enumerate() {
            assert!((tangent.direction.length() - 1.0).abs() < 1e-9);
            let step = 1e-5;
            let (_, there) = look(surface.point + tangent.direction * step);
            let grown: [f64; 2] = std::array::from_fn(|i| (there[i] - here[i]) / step);
            assert!((grown[along] * tangent.length - 1.0).abs() < 1e-3, "{grown:?} along {along}");
            assert!(grown[1 - along].abs() * tangent.length < 1e-3, "{grown:?} along {along}");
        }
    }
    let (from, to) = (Vec3::new(3.0, 4.0, 7.0), Vec3::new(0.2, 0.3, 0.1));
    check(&Sphere::new(Vec3::ZERO, 2.0), from, to);
    for normal in [[1.0, 2.0, 1.5], [2.0, 1.0, 1.5], [1.5, 1.0, 2.0]] {
        check(&Plane::new(Vec3::ZERO, Vec3::from_array(normal)), from, to);
    }
    check(&Plane::new(Vec3::ZERO, Vec3::new(0.0, 0.0, 2.0)), from, to);
    check(&Cuboid::new(Vec3::new(-2.0, -3.0, -1.0), Vec3::new(2.5, 1.0, 1.5)), from, to);
    let corners = [(-3.0, -2.0, 0.0), (4.0, -1.0, 0.5), (0.0, 5.0, -1.0)].map(|(x, y, z)| Vec3::new(x, y, z));
    check(&Triangle::new(corners[0], corners[1], corners[2]), from, to);
    let (low, high) = (Vec3::new(-0.5, -2.0, 0.25), Vec3::new(0.75, 3.0, -0.5));
    check(&Cone::new(low, 2.0, high, 0.5), from, to);
    check(&Cone::new(high, 1.5, low, 1.5), from, to);
    let across = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize().expect("a plane").0;
    let vertex = |i: usize, texture| Vertex::new(corners[i], across, texture);
    let vertices = [vertex(0, [0.5, -1.0]), vertex(1, [2.0, 0.0]), vertex(2, [0.25, 3.0])];
    check(&SmoothTriangle::new(Box::leak(Box::new(vertices))), from, to);
}

#[test]
fn a_texture_of_the_users_sends_on_no_more_than_all_light_and_no_less_than_none() {
    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        fn glaring<S: Scalar>(_: &Surface<S>) -> Rgb<S> {
            Rgb::new(S::from_i32(7), -S::ONE, S::HALF)
        }
        let place = Surface {
            point: Vec3::ZERO,
            normal: Vec3::from_array([0.0, 0.0, 1.0].map(make)),
            u: S::ZERO,
            v: S::ZERO,
            part: 0,
        };
        let color = Texture::Custom(Procedural::new(glaring)).color(&place);
        assert_color(color, [1.0, 0.0, 0.5], read);
    }
    in_every_number!(check);
    let broken: Procedural = Procedural::new(|_| Rgb::gray(f32::NAN));
    let place = Surface { point: Vec3::ZERO, normal: Vec3::ZERO, u: 0.0, v: 0.0, part: 0 };
    assert_eq!(broken.color(&place), Rgb::BLACK);
}

#[test]
fn a_texture_of_the_users_is_asked_for_each_place() {
    fn checked(place: &Surface) -> Rgb {
        if place.point.x > 0.0 { Rgb::new(1.0, 0.0, 0.0) } else { Rgb::new(0.0, 1.0, 0.0) }
    }
    let material = Material::textured(Texture::Custom(Procedural::new(checked)));
    let mut flat = material;
    flat.model = Model::Flat;
    let picture = draw(&[Object::new(ball(1.0), 0)], &[flat], NIGHT);
    let row = &picture[22 * 60..23 * 60];
    let greens = row.iter().filter(|light| light.g == 1.0 && light.r == 0.0).count();
    let reds = row.iter().filter(|light| light.r == 1.0 && light.g == 0.0).count();
    assert_eq!(greens, reds);
    assert!(reds >= 8);
}
