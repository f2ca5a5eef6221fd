//! Polygons hold what their outline surrounds by their rule, in every number.

use crate::kit::{Kit, ahead, scattered, scattered_point};
use scanray::math::Scalar;
use scanray::{FillRule, Intersect, Polygon, Triangle, Vec3};

in_every_number! {
    a_pentagram_is_hollow_by_the_odd_even_rule_and_full_by_the_winding_rule,
    a_notch_is_outside,
    polygons_that_share_edges_are_met_exactly_once_on_edges_and_corners_too,
    a_polygon_of_three_corners_is_the_triangle,
    the_order_of_the_corners_does_not_matter_but_for_newells_normal,
    what_is_run_around_as_often_one_way_as_the_other_has_no_normal_of_newell,
    a_polygon_as_large_as_the_range_is_met_where_it_is,
}

mod checks {
    use super::*;

    const STAR: [[f64; 2]; 5] =
        [[0.0, 1.0], [-0.5878, -0.809], [0.9511, 0.309], [-0.9511, 0.309], [0.5878, -0.809]];

    /// Puts points of a plane into a tilted one, which x = 1 + y / 2 - z / 4 describes.
    fn tilted([p, q]: [f64; 2]) -> [f64; 3] {
        [1.0 + p / 2.0 - q / 4.0, p, q]
    }

    const ACROSS: [f64; 3] = [4.0, -2.0, 1.0];

    fn polygon<S: Scalar>(kit: &Kit<S>, corners: &[[f64; 2]], rule: FillRule) -> Polygon<S> {
        let vertices: Vec<Vec3<S>> = corners.iter().map(|corner| kit.at(tilted(*corner))).collect();
        Polygon::new(vertices.leak(), kit.at(ACROSS), rule)
    }

    /// Tells whether a polygon is met at a point of its plane from one side and from the other.
    #[track_caller]
    fn is_met<S: Scalar>(kit: &Kit<S>, polygon: &Polygon<S>, place: [f64; 2]) -> bool {
        let [x, y, z] = tilted(place);
        let met = [5.0, -5.0].map(|off| {
            let met = kit.seen(polygon, &kit.ray_at([x + off, y + 0.7, z - 0.4], [x, y, z]));
            assert!(met.is_none_or(|t| (t - (off * off + 0.65).sqrt()).abs() < 1e-4), "met at {met:?}");
            met.is_some()
        });
        assert_eq!(met[0], met[1], "from one side only at {place:?}");
        met[0]
    }

    pub fn a_pentagram_is_hollow_by_the_odd_even_rule_and_full_by_the_winding_rule<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let [hollow, full] = [FillRule::OddEven, FillRule::Winding].map(|rule| polygon(&kit, &STAR, rule));
        for (place, times) in [([0.05, 0.1], 2), ([0.0, 0.8], 1), ([0.7, 0.25], 1), ([0.0, -0.6], 0)] {
            assert_eq!(is_met(&kit, &hollow, place), times == 1, "{place:?}");
            assert_eq!(is_met(&kit, &full, place), times > 0, "{place:?}");
        }
    }

    pub fn a_notch_is_outside<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let arrow = [[-1.0, -1.0], [1.0, 0.0], [-1.0, 1.0], [0.0, 0.0]];
        for rule in [FillRule::OddEven, FillRule::Winding] {
            let arrow = polygon(&kit, &arrow, rule);
            assert!(is_met(&kit, &arrow, [0.5, 0.1]) && is_met(&kit, &arrow, [-0.7, 0.75]));
            assert!(!is_met(&kit, &arrow, [-0.3, 0.05]) && !is_met(&kit, &arrow, [1.2, 0.0]));
        }
    }

    /// Answers a corner of a crooked net of 5 by 5.
    fn knot(i: u32, j: u32) -> [f64; 2] {
        let off = |sequence| 0.6 * scattered(5 * i + j + 1, sequence);
        [f64::from(i) - 2.0 + off(0), f64::from(j) - 2.0 + off(1)]
    }

    /// Answers the meshes of the net: of every other one the corners the other way around.
    fn meshes() -> impl Iterator<Item = [[f64; 2]; 4]> {
        (0..16).map(|n| (n / 4, n % 4)).map(|(i, j)| {
            let [a, b, c, d] = [knot(i, j), knot(i + 1, j), knot(i + 1, j + 1), knot(i, j + 1)];
            if (i + j) % 2 == 0 { [a, b, c, d] } else { [c, b, a, d] }
        })
    }

    pub fn polygons_that_share_edges_are_met_exactly_once_on_edges_and_corners_too<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let net: Vec<_> = meshes().map(|mesh| polygon(&kit, &mesh, FillRule::OddEven)).collect();
        let times_met = |place: [f64; 2], eye: [f64; 3]| {
            let ray = kit.ray_at(eye, tilted(place));
            net.iter().filter(|mesh| mesh.intersect(&ray, &ahead()).is_some()).count()
        };
        for n in 0..2000 {
            let [x, y, z] = scattered_point(n, false);
            let eye = [x + if n % 2 == 0 { 6.0 } else { -6.0 }, 3.0 * y, 3.0 * z];
            let (i, j) = (1 + n % 3, 1 + n / 3 % 3);
            let ([a, b], [c, d]) = (knot(i, j), knot(i + n % 2, j + (n + 1) % 2));
            let along = 0.5 + scattered(n, 5);
            let on_an_edge = [a + (c - a) * along, b + (d - b) * along];
            for place in [[a, b], on_an_edge] {
                assert_eq!(times_met(place, eye), 1, "{place:?} from {eye:?}");
            }
        }
    }

    pub fn a_polygon_of_three_corners_is_the_triangle<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let corners = [[-1.5, -1.25], [1.75, -0.5], [0.25, 1.5]];
        let polygon = polygon(&kit, &corners, FillRule::Winding);
        let [a, b, c] = corners.map(|corner| kit.at(tilted(corner)));
        let triangle = Triangle::new(a, b, c);
        let mut met = 0;
        for i in 0..10_000 {
            let ray = kit.ray_at(scattered_point(i, false).map(|c| 5.0 * c), scattered_point(i, true));
            let (hit, other) = (triangle.intersect(&ray, &ahead()), kit.seen(&polygon, &ray));
            let share = hit.map_or(-1.0, |hit| read(hit.u).min(read(hit.v)).min(1.0 - read(hit.u + hit.v)));
            if share < 1e-3 {
                // Of the triangle, a little beyond its edges is inside too.
                assert!(share >= 0.0 || hit.is_some() || other.is_none(), "ray {i}");
                continue;
            }
            met += 1;
            let off = kit.t(hit).zip(other).map(|(t, other)| (t - other).abs());
            assert!(off.is_some_and(|off| off < 1e-3), "ray {i}: {hit:?}, of the polygon {other:?}");
        }
        assert!(met > 500, "only {met} rays met it");
    }

    pub fn the_order_of_the_corners_does_not_matter_but_for_newells_normal<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let arrow = [[-1.0, -1.0], [1.0, 0.0], [-1.0, 1.0], [0.0, 0.0]];
        let normal = |corners: &[[f64; 2]]| {
            Polygon::newell(polygon(&kit, corners, FillRule::Winding).vertices).expect("it has area")
        };
        kit.assert_vector(normal(&arrow), [1.0, -0.5, 0.25]);
        let mut reversed = arrow;
        reversed.reverse();
        kit.assert_vector(normal(&reversed), [-1.0, 0.5, -0.25]);
        for start in 0..4 {
            reversed.rotate_left(1);
            let turned = polygon(&kit, &reversed, FillRule::Winding);
            assert!(is_met(&kit, &turned, [0.5, 0.1]) && !is_met(&kit, &turned, [-0.3, 0.05]), "{start}");
        }
    }

    pub fn what_is_run_around_as_often_one_way_as_the_other_has_no_normal_of_newell<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let bow_tie = polygon(&kit, &[[-1.0, -1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0]], FillRule::OddEven);
        assert_eq!(Polygon::newell(bow_tie.vertices), None);
        assert_eq!(Polygon::<S>::newell(&[]), None);
        // It is drawn all the same, by the normal it is given.
        assert_eq!(bow_tie.check(), Ok(()));
        assert!(is_met(&kit, &bow_tie, [0.5, 0.1]) && !is_met(&kit, &bow_tie, [0.1, 0.5]));
    }

    pub fn a_polygon_as_large_as_the_range_is_met_where_it_is<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let at = |x: f64, z: f64| kit.v(x, x / 2.0 - z / 4.0, z);
        let far = 1000.0;
        let corners = vec![at(-far, -far), at(far, -far), at(far, far), at(0.0, 10.0), at(-far, far)].leak();
        let normal = Polygon::newell(corners).expect("it has area");
        kit.assert_vector(normal, [0.5, -1.0, -0.25]);
        let field = Polygon::new(corners, normal, FillRule::Winding);
        assert_eq!(field.check(), Ok(()));
        for (x, z, inside) in [(-300.0, -200.0, true), (500.0, -700.0, true), (5.0, 300.0, false)] {
            let above = x / 2.0 - z / 4.0 + 50.0;
            let t = kit.seen(&field, &kit.ray([x, above, z], [0.0, -1.0, 0.0]));
            assert_eq!(t.is_some(), inside, "{x}, {z}");
            assert!(t.is_none_or(|t| (t - 50.0).abs() < 2e-3), "{x}, {z}: {t:?}");
        }
    }
}
