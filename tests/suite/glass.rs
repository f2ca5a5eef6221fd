//! Light through glass: no light is lost or made, and no ray dropped.

use crate::support::v;
use scanray::ray::{Interval, Ray};
use scanray::trace::{Candidates, Packet, Pending, RayCounts, Tracer};
use scanray::{
    Cone, Cuboid, Fault, Fixed, Fresnel, Glass, Material, Object, Rgb, Scalar, Scene, SceneError, Shape, Sky,
    Sphere, Triangle, Vec3,
};

/// Is black but for what it lets through.
fn pure(glass: Glass) -> Material {
    Material::matte(Rgb::BLACK).with_glass(glass)
}

fn ball(center: Vec3, radius: f32, material: u16) -> Object {
    Object::new(Shape::Sphere(Sphere::new(center, radius)), material)
}

/// Follows one ray with places for so many levels.
fn look<S: Scalar>(
    scene: &Scene<'_, S>,
    origin: Vec3<S>,
    direction: Vec3<S>,
    depth: usize,
) -> (Rgb<S>, RayCounts) {
    let mut pending = vec![Pending::NONE; depth];
    let mut counts = RayCounts::default();
    let (direction, _) = direction.normalize().expect("a direction");
    let rays = std::iter::once((Ray::new(origin, direction), Interval::AHEAD));
    let mut packet = Packet::new();
    let mut tracer = Tracer::new(scene, &mut pending);
    (tracer.radiance(&mut packet, rays, Candidates::all(scene), &mut counts)[0], counts)
}

/// Answers rays that pass a ball of radius 1 at the origin at many distances from its middle.
fn toward_a_ball() -> impl Iterator<Item = (Vec3, Vec3)> {
    (0..40).map(|i| (v(0.0, i as f32 * 0.0249, 5.0), v(0.0, 0.0, -1.0)))
}

#[test]
fn in_a_white_furnace_a_ball_of_glass_cannot_be_seen() {
    for fresnel in [Fresnel::None, Fresnel::Schlick, Fresnel::Exact] {
        let materials = [pure(Glass::new(1.0, 1.5).with_fresnel(fresnel))];
        let objects = [ball(Vec3::ZERO, 1.0, 0)];
        let scene = Scene::new(&objects, &materials, &[]).with_sky(Sky::Solid(Rgb::WHITE));
        for (origin, direction) in toward_a_ball() {
            let (light, _) = look(&scene, origin, direction, 16);
            assert!((light.g - 1.0).abs() < 1e-3, "{fresnel:?} at {}: {}", origin.y, light.g);
        }
    }
}

#[test]
fn more_levels_bring_more_light_and_never_more_than_there_is() {
    // Some rays turn back between a ball and the bubble in it twenty times before they get out.
    let exact = |index| pure(Glass::new(1.0, index).with_fresnel(Fresnel::Exact));
    let (materials, objects) =
        ([exact(1.5), exact(1.0)], [ball(Vec3::ZERO, 1.0, 0), ball(v(0.1, 0.2, 0.1), 0.5, 1)]);
    let scene = Scene::new(&objects, &materials, &[]).with_sky(Sky::Solid(Rgb::WHITE));
    for (origin, direction) in toward_a_ball() {
        let light = [0, 2, 4, 8, 16].map(|depth| look(&scene, origin, direction, depth).0.g);
        assert!(light.is_sorted() && light[4] <= 1.0 + 1e-5, "at {}: {light:?}", origin.y);
    }
}

#[test]
fn glass_of_index_1_bends_nothing() {
    let objects = [ball(Vec3::ZERO, 1.0, 0)];
    let materials = [pure(Glass::new(1.0, 1.0))];
    let sky = Sky::Gradient { up: v(0.0, 1.0, 0.0), nadir: Rgb::BLACK, zenith: Rgb::WHITE };
    let scene = Scene::new(&objects, &materials, &[]).with_sky(sky);
    for (origin, _) in toward_a_ball().take(30) {
        let direction = v(0.0, 0.02, -1.0);
        let (light, counts) = look(&scene, origin, direction, 4);
        let (plain, _) = direction.normalize().expect("a direction");
        assert!((light.r - sky.color(plain).r).abs() < 1e-5);
        assert_eq!((counts.refraction, counts.reflection), (2, 0));
    }
}

#[test]
fn a_bubble_of_air_in_glass_knows_what_it_stands_in() {
    // Straight through the middle nothing bends; at each of four surfaces 4 % turn back, and of light
    // that turns back twice the rest comes too: (1 - R) / (1 + 3 R) for four surfaces.
    let objects = [ball(Vec3::ZERO, 1.0, 0), ball(Vec3::ZERO, 0.5, 1)];
    let materials = [
        pure(Glass::new(1.0, 1.5).with_fresnel(Fresnel::Exact)),
        pure(Glass::new(1.0, 1.0).with_fresnel(Fresnel::Exact)),
    ];
    // Bright behind, dark in front.
    let sky = Sky::Gradient { up: v(0.0, 0.0, -1.0), nadir: Rgb::BLACK, zenith: Rgb::WHITE };
    let scene = Scene::new(&objects, &materials, &[]).with_sky(sky);
    let (light, _) = look(&scene, v(0.0, 0.0, 5.0), v(0.0, 0.0, -1.0), 24);
    assert!((light.r - 0.96 / 1.12).abs() < 1e-4, "{}", light.r);
}

#[test]
fn light_is_left_by_the_way_through_the_innermost_glass() {
    // From z = 1 to 0.5 through the outer, from 0.5 to -0.5 through the inner, and out again.
    let objects = [ball(Vec3::ZERO, 1.0, 0), ball(Vec3::ZERO, 0.5, 1)];
    let materials = [
        pure(Glass::new(1.0, 1.5).with_absorption(Rgb::new(0.7, 0.0, 1.0))),
        pure(Glass::new(1.0, 1.3).with_absorption(Rgb::new(0.0, 0.4, 1.0))),
    ];
    let scene = Scene::new(&objects, &materials, &[]).with_sky(Sky::Solid(Rgb::WHITE));
    let (light, _) = look(&scene, v(0.0, 0.0, 5.0), v(0.0, 0.0, -1.0), 6);
    for (light, way) in [(light.r, 0.7_f32), (light.g, 0.4), (light.b, 2.0)] {
        assert!((light - (-way).exp()).abs() < 1e-5, "{light}, not exp(-{way})");
    }
    // A thing inside is seen through what stands before it.
    let lamp = [ball(Vec3::ZERO, 1.0, 0), ball(Vec3::ZERO, 0.5, 2)];
    let materials = [materials[0], materials[1], Material::flat(Rgb::WHITE)];
    let scene = Scene::new(&lamp, &materials, &[]);
    let (light, _) = look(&scene, v(0.0, 0.0, 5.0), v(0.0, 0.0, -1.0), 6);
    assert!((light.r - (-0.35_f32).exp()).abs() < 1e-5, "{}", light.r);
}

#[test]
fn all_light_turns_back_beyond_the_critical_angle() {
    // From inside a block of 1.5, at 60 degrees to the face: the critical angle is 41.8.
    let objects = [
        Object::new(Shape::Cuboid(Cuboid::new(v(-9.0, -1.0, -9.0), v(9.0, 0.0, 9.0))), 0),
        // What the mirrored ray meets, and nothing else does.
        Object::new(
            Shape::Triangle(Triangle::new(v(1.2, -0.9, -5.0), v(1.2, -0.9, 5.0), v(1.42, -0.02, 0.0))),
            1,
        ),
    ];
    let materials = [pure(Glass::new(1.0, 1.5)), Material::flat(Rgb::WHITE)];
    let scene = Scene::new(&objects, &materials, &[]);
    let (light, counts) = look(&scene, v(-0.3, -0.9, 0.0), v(1.732_050_8, 1.0, 0.0), 4);
    assert_eq!((counts.reflection, counts.refraction), (1, 0));
    assert!((light.r - 1.0).abs() < 1e-6);
}

/// Is a ball of glass between two mirrors, which no ray gets out of: every ray splits at every
/// surface of glass until its last level.
fn between_mirrors<T>(look: impl FnOnce(&Scene<'_>) -> T) -> T {
    let mirror = |low, high| Object::new(Shape::Cuboid(Cuboid::new(low, high)), 1);
    let objects = [
        ball(Vec3::ZERO, 1.0, 0),
        mirror(v(-9.0, -9.0, 3.0), v(9.0, 9.0, 4.0)),
        mirror(v(-9.0, -9.0, -4.0), v(9.0, 9.0, -3.0)),
    ];
    let materials =
        [pure(Glass::new(0.5, 1.5)).with_mirror(0.5), Material::matte(Rgb::BLACK).with_mirror(1.0)];
    let scene = Scene::new(&objects, &materials, &[]).with_sky(Sky::Solid(Rgb::gray(0.5)));
    look(&scene)
}

#[test]
fn the_places_for_waiting_rays_are_enough_at_every_depth_and_none_is_dropped() {
    between_mirrors(|scene| {
        // Along the axis nothing bends: a ray at the ball splits in two, a ray at a mirror goes on alone.
        // Inside the ball every level doubles the rays; outside a mirror lies between two visits.
        fn rays(outside: bool, levels: usize) -> u64 {
            match (levels, outside) {
                (0, _) => 0,
                // Mirrored to a mirror and back to the ball, which takes two levels; or through.
                (_, true) => 1 + back(levels - 1) + 1 + rays(false, levels - 1),
                (_, false) => 1 + rays(false, levels - 1) + 1 + back(levels - 1),
            }
        }
        fn back(levels: usize) -> u64 {
            if levels == 0 { 0 } else { 1 + rays(true, levels - 1) }
        }
        for depth in 0..=14 {
            let (_, counts) = look(scene, v(0.0, 0.0, 2.0), v(0.0, 0.0, -1.0), depth);
            assert_eq!(counts.reflection + counts.refraction, rays(true, depth), "depth {depth}");
        }
    });
}

#[test]
fn fixed_point_sees_through_glass_what_f32_sees() {
    let number = |x: f32| Fixed::new(f64::from(x));
    let materials = [pure(Glass::new(1.0, 1.5).with_fresnel(Fresnel::Exact))];
    let objects = [ball(Vec3::ZERO, 1.0, 0)];
    let sky = Sky::Gradient { up: v(0.0, 1.0, 0.0), nadir: Rgb::BLACK, zenith: Rgb::WHITE };
    let scene = Scene::new(&objects, &materials, &[]).with_sky(sky);
    let fixed_glass = Glass::new(Fixed::ONE, number(1.5)).with_fresnel(Fresnel::Exact);
    let fixed_materials = [Material::matte(Rgb::BLACK).with_glass(fixed_glass)];
    let fixed_objects = [Object::new(Shape::Sphere(Sphere::new(Vec3::ZERO, Fixed::ONE)), 0)];
    let up = Vec3::from_f64(0.0, 1.0, 0.0);
    let fixed_sky = Sky::Gradient { up, nadir: Rgb::BLACK, zenith: Rgb::WHITE };
    let fixed = Scene::new(&fixed_objects, &fixed_materials, &[]).with_sky(fixed_sky);
    for (origin, direction) in toward_a_ball() {
        let to_fixed = |v: Vec3| Vec3::new(number(v.x), number(v.y), number(v.z));
        let (light, _) = look(&scene, origin, direction, 8);
        let (seen, _) = look(&fixed, to_fixed(origin), to_fixed(direction), 8);
        assert!((f64::from(light.r) - seen.r.to_f64()).abs() < 1e-3, "{light:?} and {seen:?}");
    }
}

#[test]
fn only_what_bounds_a_body_can_be_of_glass() {
    let flat = Triangle::new(v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0));
    let up = v(0.0, 1.0, 0.0);
    let shapes: [(Shape, bool); 6] = [
        (Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0)), true),
        (Shape::Cuboid(Cuboid::new(Vec3::ZERO, v(1.0, 1.0, 1.0))), true),
        (Shape::Cuboid(Cuboid::new(Vec3::ZERO, v(1.0, 0.0, 1.0))), false),
        (Shape::Triangle(flat), false),
        (Shape::Cone(Cone::cylinder(Vec3::ZERO, up, 1.0)), true),
        (Shape::Cone(Cone::cylinder(Vec3::ZERO, up, 1.0).open()), false),
    ];
    let materials = [pure(Glass::new(1.0, 1.5))];
    for (shape, taken) in shapes {
        let objects = [Object::new(shape, 0)];
        let ought = if taken { Ok(()) } else { Err(SceneError::Object(0, Fault::NotClosed)) };
        assert_eq!(Scene::new(&objects, &materials, &[]).check(), ought, "{shape:?}");
    }
}
