//! Cones and cylinders give the known answers, in every number.

use crate::kit::{Kit, ahead, scattered, scattered_point};
use scanray::hit::Surface;
use scanray::math::Scalar;
use scanray::ray::{Interval, Ray};
use scanray::{Cone, Intersect, Sphere};
use std::f64::consts::TAU;

in_every_number! {
    a_ray_across_a_cylinder_meets_its_near_side_and_from_inside_the_far_one,
    a_ray_along_the_axis_meets_a_cap_and_passes_through_what_is_open,
    the_side_of_a_cone_is_slanted_as_its_radius_grows,
    what_is_clipped_open_shows_the_other_wall,
    every_hit_lies_on_the_part_it_names_and_faces_outward,
    no_ray_aimed_at_the_inside_misses_a_solid,
    what_bounces_off_does_not_meet_it_again_and_what_goes_through_does,
    ends_may_be_swapped,
    a_cone_as_large_as_the_range_is_met_where_it_is,
    a_label_lies_on_a_can_as_it_does_on_a_ball,
    turned_about_its_axis_a_point_moves_along_u_alone,
}

mod checks {
    use super::*;

    /// Answers cones of every kind: a cylinder, one that grows, a point, a flat one, a slim one.
    fn cones<S: Scalar>(kit: &Kit<S>) -> Vec<Cone<S>> {
        let cone = |a: [f64; 3], r: f64, b: [f64; 3], q: f64| {
            Cone::new(kit.at(a), (kit.0)(r), kit.at(b), (kit.0)(q))
        };
        vec![
            cone([0.25, -0.5, 0.125], 0.5, [0.25, 0.75, 0.125], 0.5),
            cone([-0.5, -0.25, 0.5], 0.25, [0.5, 0.5, -0.25], 0.75),
            cone([-0.75, 0.0, 0.25], 0.625, [0.5, -0.25, 0.25], 0.0),
            cone([0.0, -0.0625, 0.0], 1.0, [0.0, 0.0625, 0.03125], 0.25),
            cone([-1.0, -1.0, -1.0], 0.03125, [1.0, 1.0, 1.0], 0.0625),
        ]
    }

    /// Answers the texture coordinates where a ray meets a shape.
    fn coordinates<S: Scalar>(shape: &impl Intersect<S>, ray: &Ray<S>) -> [S; 2] {
        let hit = shape.intersect(ray, &ahead()).expect("a hit");
        shape.texture_coordinates(&shape.surface(ray, &hit))
    }

    /// Answers how far a point is off a part of a cone, outward above 0, by the definition.
    fn off<S: Scalar>(kit: &Kit<S>, cone: &Cone<S>, part: u16, point: [f64; 3]) -> f64 {
        let (base, apex) = (kit.plain(cone.base), kit.plain(cone.apex));
        let axis = [0, 1, 2].map(|i| apex[i] - base[i]);
        let from = [0, 1, 2].map(|i| point[i] - base[i]);
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let height = dot(axis, axis).sqrt();
        let along = dot(from, axis) / height;
        let (low, high) = ((kit.1)(cone.base_radius), (kit.1)(cone.apex_radius));
        match part {
            1 => -along,
            2 => along - height,
            _ => {
                let radius = (dot(from, from) - along * along).max(0.0).sqrt();
                let slant = height.hypot(high - low);
                (radius - low - (high - low) * along / height) * height / slant
            }
        }
    }

    /// Answers a point inside a cone.
    fn inside<S: Scalar>(kit: &Kit<S>, cone: &Cone<S>, i: u32) -> [f64; 3] {
        let (base, apex) = (kit.plain(cone.base), kit.plain(cone.apex));
        let share = 0.5 + 0.98 * scattered(i, 0);
        let radius = (kit.1)(cone.base_radius) * (1.0 - share) + (kit.1)(cone.apex_radius) * share;
        let axis = [0, 1, 2].map(|i| apex[i] - base[i]);
        let [x, y, z] = scattered_point(i, true);
        let across = [axis[1] * z - axis[2] * y, axis[2] * x - axis[0] * z, axis[0] * y - axis[1] * x];
        let length = across.iter().map(|c| c * c).sum::<f64>().sqrt();
        let reach = 0.98 * radius * (2.0 * scattered(i, 1)) / length;
        [0, 1, 2].map(|i| base[i] + axis[i] * share + across[i] * reach)
    }

    pub fn a_ray_across_a_cylinder_meets_its_near_side_and_from_inside_the_far_one<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let solid = Cone::cylinder(kit.v(0.0, -1.0, 0.0), kit.v(0.0, 3.0, 0.0), make(1.0));
        for cylinder in [solid, solid.open()] {
            let ray = kit.ray([0.6, 2.0, 5.0], [0.0, 0.0, -1.0]);
            let hit = cylinder.intersect(&ray, &ahead());
            kit.assert_near(kit.t(hit), 4.2);
            let surface = cylinder.surface(&ray, &hit.expect("a hit"));
            kit.assert_vector(surface.normal, [0.6, 0.0, 0.8]);
            kit.assert_vector(surface.point, [0.6, 2.0, 0.8]);
            kit.assert_near(Some(read(cylinder.texture_coordinates(&surface)[1])), 0.75);
            kit.assert_near(kit.seen(&cylinder, &kit.ray([0.0, 0.0, 0.0], [3.0, 0.0, 4.0])), 1.0);
            assert_eq!(kit.seen(&cylinder, &kit.ray([0.0, 0.0, 5.0], [0.0, 0.0, 1.0])), None);
            assert_eq!(kit.seen(&cylinder, &kit.ray([1.001, 0.0, 5.0], [0.0, 0.0, -1.0])), None);
            assert_eq!(kit.seen(&cylinder, &kit.ray([0.0, 3.001, 5.0], [0.0, 0.0, -1.0])), None);
        }
    }

    pub fn a_ray_along_the_axis_meets_a_cap_and_passes_through_what_is_open<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        for cone in cones(&kit).into_iter().take(2) {
            let (base, apex) = (kit.plain(cone.base), kit.plain(cone.apex));
            let start = [0, 1, 2].map(|i| 3.0 * apex[i] - 2.0 * base[i]);
            let height = [0, 1, 2].map(|i| apex[i] - base[i]).iter().map(|c| c * c).sum::<f64>().sqrt();
            let ray = kit.ray_at(start, base);
            let hit = cone.intersect(&ray, &ahead()).expect("the cap");
            kit.assert_near(Some(read(hit.t)), 2.0 * height);
            assert_eq!(hit.part, 2);
            let surface = cone.surface(&ray, &hit);
            kit.assert_vector(surface.point, apex);
            kit.assert_vector(surface.normal, kit.plain(-ray.direction));
            let [_, v] = cone.texture_coordinates(&surface);
            assert!(read(v) > 0.9999 && v < S::ONE);
            let out = cone.intersect_leaving(&Ray::new(surface.point, ray.direction), &ahead());
            kit.assert_near(kit.t(out), height);
            assert_eq!(out.map(|out| out.part), Some(1));
            assert_eq!(kit.seen(&cone.open(), &ray), None);
        }
    }

    pub fn the_side_of_a_cone_is_slanted_as_its_radius_grows<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let hat = Cone::new(kit.v(0.0, 0.0, 0.0), make(1.5), kit.v(0.0, 2.0, 0.0), make(0.0));
        let ray = kit.ray([-4.0, 1.0, 0.0], [1.0, 0.0, 0.0]);
        let hit = hat.intersect(&ray, &ahead());
        kit.assert_near(kit.t(hit), 3.25);
        let surface = hat.surface(&ray, &hit.expect("a hit"));
        kit.assert_vector(surface.normal, [-0.8, 0.6, 0.0]);
        kit.assert_near(Some(read(hat.texture_coordinates(&surface)[1])), 0.5);
        // Nothing of the other half of the double cone is there.
        assert_eq!(kit.seen(&hat, &kit.ray([-4.0, 2.5, 0.0], [1.0, 0.0, 0.0])), None);
        // Along a line of the side, a little inside: in through the base, out near the apex.
        let along = kit.ray([1.5, -0.1, 0.0], [-1.5, 2.0, 0.0]);
        let hit = hat.intersect(&along, &ahead()).expect("a hit");
        assert_eq!(hit.part, 1);
        kit.assert_near(Some(read(hit.t)), 0.125);
    }

    pub fn what_is_clipped_open_shows_the_other_wall<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let tube = Cone::cylinder(kit.v(0.0, -1.0, 0.0), kit.v(0.0, 1.0, 0.0), make(1.0)).open();
        let ray = kit.ray([0.0, 0.0, 5.0], [0.0, 0.0, -1.0]);
        let seen = |near, far| kit.t(tube.intersect(&ray, &Interval::new(make(near), make(far))));
        kit.assert_near(seen(0.0, 9.0), 4.0);
        kit.assert_near(seen(4.5, 9.0), 6.0);
        assert_eq!(seen(4.5, 5.5), None);
        // In over the rim, and onto the inside of the far wall.
        let hit = tube.intersect(&kit.ray([0.0, 2.5, 2.0], [0.0, -2.0, -2.0]), &ahead()).expect("a hit");
        assert_eq!(hit.part, 0);
        kit.assert_near(Some(read(hit.t)), 18.0_f64.sqrt());
    }

    pub fn every_hit_lies_on_the_part_it_names_and_faces_outward<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        for (n, cone) in cones(&kit).into_iter().enumerate() {
            let mut parts = [0; 3];
            for i in 0..10_000 {
                let from = scattered_point(i, false).map(|c| 6.0 * c);
                let ray = kit.ray_at(from, scattered_point(i, true));
                let Some(hit) = cone.intersect(&ray, &ahead()) else { continue };
                parts[usize::from(hit.part)] += 1;
                let surface = cone.surface(&ray, &hit);
                let point = kit.plain(surface.point);
                let [side, base, apex] = [0, 1, 2].map(|part| off(&kit, &cone, part, point));
                let own = [side, base, apex][usize::from(hit.part)];
                assert!(own.abs() < 5e-6, "cone {n}, ray {i}: off by {own}");
                // A long way in the ray is as much wrong as its direction is.
                assert!(side.max(base).max(apex) < 2e-3, "cone {n}, ray {i}: {side} {base} {apex}");
                let outward = [0, 1, 2].map(|axis| point[axis] + 0.01 * kit.plain(surface.normal)[axis]);
                let gained = off(&kit, &cone, hit.part, outward) - own;
                assert!((gained - 0.01).abs() < 2e-5, "cone {n}, ray {i}: a normal of {gained}");
            }
            assert!(parts[0] > 50, "cone {n}: {parts:?}");
        }
    }

    pub fn no_ray_aimed_at_the_inside_misses_a_solid<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        for (n, cone) in cones(&kit).into_iter().enumerate() {
            for i in 1..4000 {
                let from = scattered_point(i, false).map(|c| c + c.signum() * 3.0);
                let ray = kit.ray_at(from, inside(&kit, &cone, i));
                assert!(cone.intersect(&ray, &ahead()).is_some(), "cone {n}, ray {i}");
            }
        }
    }

    pub fn what_bounces_off_does_not_meet_it_again_and_what_goes_through_does<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        for (n, cone) in cones(&kit).into_iter().enumerate().take(3) {
            for i in 1..2000 {
                let from = scattered_point(i, false).map(|c| c + c.signum() * 3.0);
                let ray = kit.ray_at(from, inside(&kit, &cone, i));
                let hit = cone.intersect(&ray, &ahead()).expect("aimed at the inside");
                let surface = cone.surface(&ray, &hit);
                let slope = read(surface.normal.dot(ray.direction));
                assert!(cone.is_convex() && slope < 1e-4);
                // Asked of bumpy cones alone.
                let outward = Ray::new(surface.point, ray.direction.reflect(surface.normal));
                assert!(
                    slope > -1e-3 || cone.intersect_leaving(&outward, &ahead()).is_none(),
                    "cone {n}, ray {i}"
                );
                let through = Ray::new(surface.point, ray.direction);
                let leaves = cone.intersect_leaving(&through, &ahead()).expect("the far side");
                let far = kit.plain(cone.surface(&through, &leaves).point);
                assert!(off(&kit, &cone, leaves.part, far).abs() < 5e-6, "cone {n}, ray {i}");
            }
        }
    }

    pub fn ends_may_be_swapped<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        for (n, cone) in cones(&kit).into_iter().enumerate().take(3) {
            let swapped = Cone::new(cone.apex, cone.apex_radius, cone.base, cone.base_radius);
            for i in 1..2000 {
                let from = scattered_point(i, false).map(|c| c + c.signum() * 3.0);
                let ray = kit.ray_at(from, inside(&kit, &cone, i));
                let [one, other] = [cone, swapped].map(|cone| cone.intersect(&ray, &ahead()).expect("a hit"));
                assert!((read(one.t) - read(other.t)).abs() < 1e-3, "cone {n}, ray {i}");
                // At a rim, rounding may name either part.
                let same = [0, 2, 1][usize::from(one.part)] == other.part;
                let point = kit.plain(cone.surface(&ray, &one).point);
                let part = other.part.min(1) * (3 - other.part);
                assert!(same || off(&kit, &cone, part, point).abs() < 1e-4, "cone {n}, ray {i}");
            }
        }
    }

    pub fn a_cone_as_large_as_the_range_is_met_where_it_is<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let tower = Cone::new(kit.v(0.0, -900.0, 0.0), make(600.0), kit.v(0.0, 900.0, 0.0), make(240.0));
        assert_eq!(tower.check(), Ok(()));
        // At the height of 100 its radius is 400.
        let ray = kit.ray([240.0, 100.0, 1000.0], [0.0, 0.0, -1.0]);
        let t = kit.seen(&tower, &ray).expect("a hit");
        assert!((t - 680.0).abs() < 2e-3, "{t}");
        let down = kit.ray([100.0, 1000.0, -200.0], [0.0, -1.0, 0.0]);
        kit.assert_near(kit.seen(&tower, &down), 100.0);
        assert_eq!(kit.seen(&tower, &kit.ray([401.0, 100.0, 1000.0], [0.0, 0.0, -1.0])), None);
    }

    pub fn a_label_lies_on_a_can_as_it_does_on_a_ball<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let can = Cone::new(kit.v(2.0, -1.0, 0.5), make(1.5), kit.v(2.0, 2.0, 0.5), make(0.5));
        let ball = Sphere::new(kit.v(2.0, 0.5, 0.5), make(0.25));
        for i in 0..2000 {
            let level = 1.5 * scattered(i, 0) + 0.5;
            let angle = TAU * scattered(i, 1);
            let at_height = |y| {
                let from = [2.0 + 9.0 * angle.cos(), y, 0.5 + 9.0 * angle.sin()];
                kit.ray_at(from, [2.0, y, 0.5])
            };
            let [on_can, on_ball] =
                [coordinates(&can, &at_height(level)), coordinates(&ball, &at_height(0.5))];
            assert!((read(on_can[0]) - read(on_ball[0])).abs() < 1e-5, "ray {i}: {on_can:?}, {on_ball:?}");
            assert!((read(on_can[1]) - (level + 1.0) / 3.0).abs() < 1e-5, "ray {i}: {on_can:?}");
        }
    }

    /// Turns a vector about an axis of any length (Rodrigues 1840).
    fn turned(v: [f64; 3], axis: [f64; 3], angle: f64) -> [f64; 3] {
        let length = axis.iter().map(|c| c * c).sum::<f64>().sqrt();
        let k = axis.map(|c| c / length);
        let along = (0..3).map(|i| k[i] * v[i]).sum::<f64>() * (1.0 - angle.cos());
        let across = [k[1] * v[2] - k[2] * v[1], k[2] * v[0] - k[0] * v[2], k[0] * v[1] - k[1] * v[0]];
        [0, 1, 2].map(|i| v[i] * angle.cos() + across[i] * angle.sin() + k[i] * along)
    }

    pub fn turned_about_its_axis_a_point_moves_along_u_alone<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        for (n, cone) in cones(&kit).into_iter().enumerate().take(4) {
            let (base, apex) = (kit.plain(cone.base), kit.plain(cone.apex));
            let axis = [0, 1, 2].map(|i| apex[i] - base[i]);
            for i in 1..1000 {
                let from = scattered_point(i, false).map(|c| c + c.signum() * 3.0);
                let ray = kit.ray_at(from, inside(&kit, &cone, i));
                let hit = cone.intersect(&ray, &ahead()).expect("aimed at the inside");
                let surface = cone.surface(&ray, &hit);
                let point = kit.plain(surface.point);
                let off_axis = [0, 1, 2].map(|i| point[i] - base[i]);
                let quarter = turned(off_axis, axis, TAU / 4.0);
                let there = Surface { point: kit.at([0, 1, 2].map(|i| base[i] + quarter[i])), ..surface };
                let [[u, v], [turned_u, same_v]] =
                    [surface, there].map(|place| cone.texture_coordinates(&place).map(read));
                // Anticlockwise as seen from the apex, and near the axis as well as a number may.
                let back = turned(off_axis, axis, TAU / 2.0);
                let radius = (0..3).map(|i| (off_axis[i] - back[i]).powi(2)).sum::<f64>().sqrt() / 2.0;
                let slack = 2e-5 + 1e-6 / radius;
                let turn = (turned_u - u - 0.25).rem_euclid(1.0);
                assert!(turn.min(1.0 - turn) < slack, "cone {n}, ray {i}: from {u} to {turned_u}");
                assert!((same_v - v).abs() < 2e-4, "cone {n}, ray {i}: from {v} to {same_v}");
                if surface.part > 0 {
                    let rim = f64::from(surface.part - 1);
                    assert!((v - rim).abs() < 2e-4, "cone {n}, ray {i}: {v} on a cap");
                }
            }
        }
    }
}
