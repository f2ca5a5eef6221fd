//! Shapes give the known answers, in every number.

use crate::kit::{Kit, ahead};
use scanray::math::Scalar;
use scanray::ray::{Interval, Ray};
use scanray::{Cuboid, Intersect, Plane, Sphere, Triangle};

in_every_number! {
    a_ray_at_a_ball_hits_its_near_side,
    from_inside_a_ball_the_far_side_is_hit,
    a_ball_behind_is_not_hit,
    a_grazing_ray_just_inside_hits_and_just_outside_misses,
    a_clipped_near_side_shows_the_far_side,
    a_ray_that_leaves_a_ball_meets_it_again_only_inward,
    a_large_ball_has_its_points_on_its_surface,
    a_ball_blocks_where_a_crossing_lies_on_the_way,
    what_bounces_off_a_box_does_not_meet_it_again,
    a_ray_along_a_face_of_a_box_counts_as_inside,
    each_face_of_a_box_is_named_and_faces_outward,
    from_inside_a_box_the_way_out_is_found,
    a_box_without_height_is_a_rectangle,
    a_ray_that_skims_a_box_is_not_bent,
    no_ray_slips_through_between_two_triangles,
    a_triangle_is_hit_inside_its_edges_and_from_both_sides,
    a_large_triangle_does_not_overflow,
    a_plane_is_hit_once_and_never_again,
}

#[test]
fn in_floats_a_triangle_reaches_as_far_beyond_each_of_its_corners() {
    checks::in_floats_a_triangle_reaches_as_far_beyond_each_of_its_corners(|x| x as f32, f64::from);
    checks::in_floats_a_triangle_reaches_as_far_beyond_each_of_its_corners(|x| x, |x| x);
}

mod checks {
    use super::*;

    pub fn a_ray_at_a_ball_hits_its_near_side<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let ball = Sphere::new(kit.v(0.0, 0.0, -5.0), make(2.0));
        let ray = kit.ray([0.0, 0.0, 0.0], [0.0, 0.0, -1.0]);
        let hit = ball.intersect(&ray, &ahead());
        kit.assert_near(kit.t(hit), 3.0);
        let surface = ball.surface(&ray, &hit.expect("a hit"));
        assert!((read(surface.normal.z) - 1.0).abs() < 1e-5);
    }

    pub fn from_inside_a_ball_the_far_side_is_hit<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let ball = Sphere::new(kit.v(0.0, 0.0, -1.0), make(4.0));
        let ray = kit.ray([0.0, 0.0, 0.0], [0.0, 0.0, -1.0]);
        kit.assert_near(kit.t(ball.intersect(&ray, &ahead())), 5.0);
    }

    pub fn a_ball_behind_is_not_hit<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let ball = Sphere::new(kit.v(0.0, 0.0, 5.0), make(2.0));
        let ray = kit.ray([0.0, 0.0, 0.0], [0.0, 0.0, -1.0]);
        assert!(ball.intersect(&ray, &ahead()).is_none());
    }

    pub fn a_grazing_ray_just_inside_hits_and_just_outside_misses<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let ball = Sphere::new(kit.v(0.0, 0.0, -10.0), make(2.0));
        let at = |height: f64| {
            let ray = kit.ray([0.0, height, 0.0], [0.0, 0.0, -1.0]);
            ball.intersect(&ray, &ahead()).is_some()
        };
        assert!(at(1.9999));
        assert!(!at(2.0001));
    }

    pub fn a_clipped_near_side_shows_the_far_side<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let ball = Sphere::new(kit.v(0.0, 0.0, -5.0), make(2.0));
        let ray = kit.ray([0.0, 0.0, 0.0], [0.0, 0.0, -1.0]);
        let clipped = |near, far| kit.t(ball.intersect(&ray, &Interval::new(make(near), make(far))));
        kit.assert_near(clipped(4.0, 100.0), 7.0);
        assert_eq!(clipped(4.0, 6.5), None);
    }

    pub fn a_ray_that_leaves_a_ball_meets_it_again_only_inward<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let ball = Sphere::new(kit.v(0.0, 0.0, 0.0), make(1.0));
        let leaving = |toward| ball.intersect_leaving(&kit.ray([0.0, 0.0, 1.0], toward), &ahead());
        kit.assert_near(kit.t(leaving([0.0, 0.0, -1.0])), 2.0);
        assert!(leaving([0.0, 0.0, 1.0]).is_none());
        assert!(leaving([0.9, 0.0, 0.1]).is_none());
    }

    pub fn a_large_ball_has_its_points_on_its_surface<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let ball = Sphere::new(kit.v(0.0, -1000.0, 2.0), make(999.0));
        for x in -20..20 {
            let ray = kit.ray([0.0, 6.0, -17.0], [f64::from(x) * 0.02, -0.3, 1.0]);
            let hit = ball.intersect(&ray, &ahead()).expect("the ground is everywhere");
            let point = ball.surface(&ray, &hit).point.to_array().map(read);
            let [x, y, z] = [point[0], point[1] + 1000.0, point[2] - 2.0];
            let off = (x * x + y * y + z * z).sqrt() - 999.0;
            // A step of f32 at 1000 is 6e-5; fixed point comes within a few of its own.
            let is_float = read(make(1e-7)) > 0.0;
            assert!(off.abs() < if is_float { 2e-4 } else { 4e-6 }, "off by {off}");
        }
    }

    pub fn a_ball_blocks_where_a_crossing_lies_on_the_way<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let ball = Sphere::new(kit.v(0.0, 0.0, 0.0), make(1.0));
        // From before it, from within it on both sides of its middle, and from behind it.
        for start in [-3.0, -0.5, 0.5, 3.0] {
            let ray = kit.ray([0.0, 0.0, start], [0.0, 0.0, 1.0]);
            for (near, far) in
                [(0.0, 0.2), (0.0, 0.8), (0.0, 2.8), (0.0, 9.0), (0.7, 9.0), (1.7, 3.0), (2.6, 9.0)]
            {
                let on_the_way = |t: f64| near < t && t < far;
                let crossed = on_the_way(-1.0 - start) || on_the_way(1.0 - start);
                let blocked = ball.occludes(&ray, &Interval::new(make(near), make(far)));
                assert_eq!(blocked, crossed, "from {start}, {near} to {far}");
            }
        }
    }

    fn cube<S: Scalar>(kit: &Kit<S>) -> Cuboid<S> {
        Cuboid::new(kit.v(-1.0, -2.0, -3.0), kit.v(1.0, 2.0, 3.0))
    }

    pub fn a_ray_along_a_face_of_a_box_counts_as_inside<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let along = |x: f64| {
            let ray = kit.ray([x, 0.0, 10.0], [0.0, 0.0, -1.0]);
            kit.t(cube(&kit).intersect(&ray, &ahead()))
        };
        kit.assert_near(along(1.0), 7.0);
        kit.assert_near(along(-1.0), 7.0);
        assert_eq!(along(1.001), None);
    }

    pub fn each_face_of_a_box_is_named_and_faces_outward<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let from = [
            [-9.0, 0.0, 0.0],
            [9.0, 0.0, 0.0],
            [0.0, -9.0, 0.0],
            [0.0, 9.0, 0.0],
            [0.0, 0.0, -9.0],
            [0.0, 0.0, 9.0],
        ];
        for (face, origin) in from.into_iter().enumerate() {
            let ray = kit.ray(origin, origin.map(|c| -c));
            let hit = cube(&kit).intersect(&ray, &ahead()).expect("a hit");
            assert_eq!(usize::from(hit.part), face);
            let surface = cube(&kit).surface(&ray, &hit);
            assert!(read(surface.normal.dot(ray.direction)) < -0.999);
            assert!((read(surface.u) - 0.5).abs() < 1e-5 && (read(surface.v) - 0.5).abs() < 1e-5);
        }
    }

    pub fn from_inside_a_box_the_way_out_is_found<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let out = kit.ray([0.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        kit.assert_near(kit.t(cube(&kit).intersect(&out, &ahead())), 2.0);
        let across = kit.ray([0.0, -2.0, 0.0], [0.0, 1.0, 0.0]);
        kit.assert_near(kit.t(cube(&kit).intersect_leaving(&across, &ahead())), 4.0);
        let away = kit.ray([0.0, 2.0, 0.0], [0.3, 1.0, 0.0]);
        assert!(cube(&kit).intersect_leaving(&away, &ahead()).is_none());
    }

    pub fn what_bounces_off_a_box_does_not_meet_it_again<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        for i in 0..2000 {
            let at = |step: f64| (f64::from(i) * step).fract() - 0.5;
            let from = [at(0.618) * 30.0, 9.0, at(0.755) * 30.0];
            let to = [at(0.324) * 1.9, at(0.541) * 3.9, at(0.217) * 5.9];
            let ray = kit.ray(from, [to[0] - from[0], to[1] - from[1], to[2] - from[2]]);
            let hit = cube(&kit).intersect(&ray, &ahead()).expect("aimed at the inside");
            let surface = cube(&kit).surface(&ray, &hit);
            let bounce = Ray::new(surface.point, ray.direction.reflect(surface.normal));
            assert!(cube(&kit).intersect_leaving(&bounce, &ahead()).is_none(), "ray {i}");
            let through = Ray::new(surface.point, ray.direction);
            assert!(cube(&kit).intersect_leaving(&through, &ahead()).is_some(), "ray {i}");
        }
    }

    pub fn a_ray_that_skims_a_box_is_not_bent<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let slab = Cuboid::new(kit.v(-50.0, -1.0, -200.0), kit.v(50.0, 0.0, 0.0));
        // 0.01 above and falling 1e-4 a unit: it touches down 100 units away, beyond a reciprocal's
        // reach in fixed point.
        let ray = kit.ray([0.0, 0.01, 0.0], [0.0, -1e-4, -1.0]);
        let t = kit.t(slab.intersect(&ray, &ahead())).expect("a hit");
        // One step of the direction, 1e-6 of 1e-4, is one unit of the distance.
        assert!((t - 100.0).abs() < 1.0, "touches down at {t}");
        let shorter = Cuboid::new(kit.v(-50.0, -1.0, -90.0), kit.v(50.0, 0.0, 0.0));
        assert!(shorter.intersect(&ray, &ahead()).is_none());
    }

    pub fn no_ray_slips_through_between_two_triangles<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let corners = [[-1.7, 0.3, -4.1], [2.9, -0.8, -5.3], [0.4, 3.1, -6.2], [1.1, -2.7, -4.4]];
        let [a, b, c, d] = corners.map(|[x, y, z]| kit.v(x, y, z));
        let sides = [Triangle::new(a, b, c), Triangle::new(b, a, d)];
        for i in 1..1000 {
            let along = f64::from(i) / 1000.0;
            let at = |k: usize| corners[0][k] + (corners[1][k] - corners[0][k]) * along;
            let ray = kit.ray([0.0, 0.0, 0.0], [at(0), at(1), at(2)]);
            assert!(sides.iter().any(|side| side.intersect(&ray, &ahead()).is_some()), "at {along}");
        }
    }

    pub fn a_box_without_height_is_a_rectangle<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let floor = Cuboid::new(kit.v(-1.0, 0.0, -1.0), kit.v(1.0, 0.0, 1.0));
        assert!(floor.check().is_ok());
        for height in [2.0, -2.0] {
            let ray = kit.ray([0.5, height, 0.5], [0.0, -height, 0.0]);
            kit.assert_near(kit.t(floor.intersect(&ray, &ahead())), 2.0);
            let beside = kit.ray([1.5, height, 0.5], [0.0, -height, 0.0]);
            assert!(floor.intersect(&beside, &ahead()).is_none());
        }
        let up = kit.ray([0.5, 0.0, 0.5], [0.2, 1.0, 0.0]);
        assert!(floor.intersect_leaving(&up, &ahead()).is_none());
    }

    pub fn a_triangle_is_hit_inside_its_edges_and_from_both_sides<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let triangle = Triangle::new(kit.v(0.0, 0.0, 0.0), kit.v(4.0, 0.0, 0.0), kit.v(0.0, 4.0, 0.0));
        for side in [5.0, -5.0] {
            let at = |x, y| triangle.intersect(&kit.ray([x, y, side], [0.0, 0.0, -side]), &ahead());
            let hit = at(1.0, 2.0);
            kit.assert_near(kit.t(hit), 5.0);
            let hit = hit.expect("a hit");
            kit.assert_near(Some(read(hit.u)), 0.25);
            kit.assert_near(Some(read(hit.v)), 0.5);
            for (x, y) in [(-0.01, 1.0), (1.0, -0.01), (2.01, 2.01)] {
                assert!(at(x, y).is_none(), "hit outside at {x}, {y}");
            }
        }
        let beside = kit.ray([0.0, 0.0, 1.0], [1.0, 1.0, 0.0]);
        assert!(triangle.intersect(&beside, &ahead()).is_none());
    }

    pub fn in_floats_a_triangle_reaches_as_far_beyond_each_of_its_corners<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let corners = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
        let [a, b, c] = corners.map(|[x, y]| kit.v(x, y, 0.0));
        let triangle = Triangle::new(a, b, c);
        for corner in 0..3 {
            // Beyond both of a corner's edges by a share of the height over them, so by twice that past the third's.
            let is_met = |share: f64| {
                let weight = |i| if i == corner { 1.0 + 2.0 * share } else { -share };
                let [x, y] = [0, 1].map(|axis| (0..3).map(|i| weight(i) * corners[i][axis]).sum());
                triangle.intersect(&kit.ray([x, y, 5.0], [0.0, 0.0, -1.0]), &ahead()).is_some()
            };
            assert!(is_met(0.75 / 65536.0), "corner {corner}");
            assert!(!is_met(1.25 / 65536.0), "corner {corner}");
        }
    }

    pub fn a_large_triangle_does_not_overflow<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let triangle =
            Triangle::new(kit.v(-500.0, 0.0, -500.0), kit.v(500.0, 0.0, -500.0), kit.v(0.0, 0.0, 500.0));
        assert!(triangle.check().is_ok());
        let ray = kit.ray([10.0, 300.0, -20.0], [0.0, -1.0, 0.0]);
        kit.assert_near(kit.t(triangle.intersect(&ray, &ahead())), 300.0);
    }

    pub fn a_plane_is_hit_once_and_never_again<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let plane = Plane::new(kit.v(0.0, -2.0, 0.0), kit.v(0.0, 7.0, 0.0));
        let down = kit.ray([3.0, 1.0, 4.0], [0.0, -1.0, 0.0]);
        let hit = plane.intersect(&down, &ahead());
        kit.assert_near(kit.t(hit), 3.0);
        let surface = plane.surface(&down, &hit.expect("a hit"));
        kit.assert_near(Some(read(surface.u)), 3.0);
        kit.assert_near(Some(read(surface.v)), 4.0);
        assert!((read(surface.normal.y) - 1.0).abs() < 1e-5);
        let along = kit.ray([0.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
        assert!(plane.intersect(&along, &ahead()).is_none());
        assert!(plane.intersect(&kit.ray([0.0, 0.0, 0.0], [0.0, 1.0, 0.0]), &ahead()).is_none());
        assert!(plane.intersect_leaving(&down, &ahead()).is_none());
    }
}
