//! Hierarchies leave out nothing: meshes with them are those without, to the bit.

use host_sim::bake::{Accel, Bounds, Bvh};
use host_sim::growth::{Crowd, Thing};
use host_sim::rounded::Rounded;
use proptest::prelude::*;
use scanray::math::Vec3;
use scanray::ray::{Interval, Ray};
use scanray::{Corners, Fixed, Intersect, Mesh, Normals};

type Point = [f64; 3];

/// Makes the same triangles twice: with a hierarchy, and asked one by one.
fn meshes<S: Rounded>(triangles: &[[Point; 3]], accel: Accel) -> [&'static Mesh<S>; 2] {
    let places: Vec<Vec3<S>> =
        triangles.iter().flatten().map(|p| Vec3::from_array(p.map(S::round))).collect();
    let numbers: Vec<[u16; 3]> = (0..triangles.len() as u16).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
    let bounds: Vec<Bounds> = triangles.iter().map(|corners| Bounds::around(*corners)).collect();
    let corners = Corners::Exact(places.leak());
    let numbers: &'static [[u16; 3]] = numbers.leak();
    [accel, Accel::None].map(|accel| {
        let mesh = Mesh::new(numbers, corners, Normals::Flat, accel.build(&bounds).leak::<S>());
        &*Box::leak(Box::new(mesh))
    })
}

fn point(reach: f64) -> impl Strategy<Value = Point> {
    prop::array::uniform3(-reach..reach)
}

/// Answers triangles of all sizes, some of them flat along an axis and some the same twice.
fn triangles() -> impl Strategy<Value = Vec<[Point; 3]>> {
    let size = prop_oneof![Just(0.01), Just(0.3), Just(3.0), Just(40.0)];
    let triangle = (point(20.0), size, prop::array::uniform3(point(1.0)), 0..4_usize).prop_map(
        |(at, size, corners, flat)| {
            corners.map(|corner| {
                std::array::from_fn(|axis| at[axis] + if axis == flat { 0.0 } else { size * corner[axis] })
            })
        },
    );
    prop::collection::vec(triangle, 1..60).prop_map(|mut list| {
        let again = list[0];
        list.push(again);
        list
    })
}

/// Answers where a ray starts and a point toward which it goes, sometimes along an axis.
fn rays() -> impl Strategy<Value = Vec<(Point, Point)>> {
    let toward = (point(1.0), 0..8_usize).prop_map(|(mut toward, axis)| {
        for (at, value) in toward.iter_mut().enumerate() {
            // The last bits say which coordinates are 0 or nearly 0.
            *value *= if axis >> at & 1 == 1 { 1e-4 } else { 1.0 };
        }
        toward
    });
    prop::collection::vec((point(60.0), toward, point(20.0), any::<bool>()), 50).prop_map(|list| {
        let aim = |(from, toward, at, aimed): (Point, Point, Point, bool)| {
            (from, if aimed { std::array::from_fn(|i| at[i] - from[i]) } else { toward })
        };
        list.into_iter().map(aim).collect()
    })
}

fn check<S: Rounded>(
    triangles: &[[Point; 3]],
    rays: &[(Point, Point)],
    accel: Accel,
) -> Result<(), TestCaseError> {
    let [with, without] = meshes::<S>(triangles, accel);
    prop_assert_eq!(with.check(), Ok(()));
    for (from, toward) in rays {
        let vector = |p: &Point| Vec3::from_array(p.map(S::round));
        let Some((direction, _)) = vector(toward).normalize() else { continue };
        let ray = Ray::new(vector(from), direction);
        for interval in [Interval::AHEAD, Interval::new(S::ONE, S::round(30.0))] {
            prop_assert_eq!(with.intersect(&ray, &interval), without.intersect(&ray, &interval), "{:?}", ray);
            prop_assert_eq!(with.occludes(&ray, &interval), without.occludes(&ray, &interval), "{:?}", ray);
        }
    }
    Ok(())
}

macro_rules! leaves_out_no_triangle {
    ($($test:ident: $accel:ident in $number:ty;)*) => {
        proptest! {
            #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

            $(#[test]
            fn $test(triangles in triangles(), rays in rays()) {
                check::<$number>(&triangles, &rays, Accel::$accel)?;
            })*
        }
    };
}

leaves_out_no_triangle! {
    a_bvh_leaves_out_no_triangle_in_f32: Bvh in f32;
    a_bvh_leaves_out_no_triangle_in_fixed_point: Bvh in Fixed;
    a_bvh_leaves_out_no_triangle_in_f64: Bvh in f64;
    a_kd_tree_leaves_out_no_triangle_in_f32: Kd in f32;
    a_kd_tree_leaves_out_no_triangle_in_fixed_point: Kd in Fixed;
    a_kd_tree_leaves_out_no_triangle_in_f64: Kd in f64;
    an_octree_leaves_out_no_triangle_in_f32: Octree in f32;
    an_octree_leaves_out_no_triangle_in_fixed_point: Octree in Fixed;
    an_octree_leaves_out_no_triangle_in_f64: Octree in f64;
    a_grid_leaves_out_no_triangle_in_f32: Grid in f32;
    a_grid_leaves_out_no_triangle_in_fixed_point: Grid in Fixed;
    a_grid_leaves_out_no_triangle_in_f64: Grid in f64;
}

#[test]
fn as_many_things_as_a_number_can_name_are_held_by_every_kind() {
    let balls = Crowd::Balls.sizes().pop().unwrap();
    let bounds: Vec<Bounds> = balls.iter().take(65_535).map(Thing::bounds).collect();
    for accel in Accel::ALL {
        let hierarchy = accel.build(&bounds).leak::<f32>();
        assert_eq!((hierarchy.count(), hierarchy.check()), (65_535, Ok(())), "{accel:?}");
    }
}

#[test]
fn a_tree_of_boxes_over_things_in_its_own_order_is_the_same_without_a_list() {
    let balls = Crowd::Balls.sizes().into_iter().find(|balls| balls.len() > 1000).unwrap();
    let bounds: Vec<Bounds> = balls.iter().map(Thing::bounds).collect();
    let first = Bvh::build(&bounds);
    let ordered: Vec<Bounds> = first.order.iter().map(|ball| bounds[usize::from(*ball)]).collect();
    let second = Bvh::build(&ordered);
    assert_eq!(second.nodes, first.nodes);
    assert!(!first.leak::<f32>().items.is_empty() && second.leak::<f32>().items.is_empty());
}

#[test]
fn over_nothing_nothing_is_met() {
    let ray = Ray::new(Vec3::ZERO, Vec3::new(1.0, 0.0, 0.0));
    for accel in Accel::ALL {
        let hierarchy = accel.build(&[]).leak::<f64>();
        assert_eq!((hierarchy.count(), hierarchy.check()), (0, Ok(())), "{accel:?}");
        hierarchy.walk(&ray, &Interval::AHEAD, &mut |number| panic!("{accel:?} names {number}"));
    }
}
