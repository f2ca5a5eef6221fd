//! The work of a ray grows with the logarithm of the number of things, where there is a tree over them.

use crate::desk::{Desk, assert_refused, read, stdout};
use host_sim::bake::{Accel, Bounds};
use host_sim::growth::{Crowd, Tally, Thing, measure};
use scanray::Scalar;
use std::collections::HashMap;

/// Answers the operations of a ray over crowds of some hundreds and of some ten thousands, with how many they
/// are.
fn growth(crowd: Crowd, accel: Accel) -> [(f64, f64); 2] {
    let sizes = crowd.sizes();
    let measured = |things: &Vec<Thing>| (things.len() as f64, measure(crowd, things, accel).operations);
    let of = |least: usize| sizes.iter().find(|things| things.len() >= least).map(measured);
    [of(300), of(10_000)].map(Option::unwrap)
}

#[test]
fn the_work_of_trees_grows_no_faster_than_the_logarithm() {
    for (crowd, accel) in Crowd::ALL
        .into_iter()
        .flat_map(|crowd| [Accel::Bvh, Accel::Kd, Accel::Octree].map(|accel| (crowd, accel)))
    {
        let [(few, small), (many, large)] = growth(crowd, accel);
        let allowed = many.ln() / few.ln();
        assert!(large / small < 1.25 * allowed, "{crowd:?}, {accel:?}: {small} to {large}, not by {allowed}");
    }
}

#[test]
fn without_a_hierarchy_the_work_is_that_of_every_thing() {
    for crowd in Crowd::ALL {
        let [(few, small), (many, large)] = growth(crowd, Accel::None);
        let ratio = large / small / (many / few);
        assert!((0.8..1.25).contains(&ratio), "{crowd:?}: {small} to {large}");
        let fewest = &crowd.sizes()[0];
        assert_eq!(measure(crowd, fewest, Accel::None).asked, fewest.len() as f64);
    }
}

#[test]
fn the_bumpy_ball_is_closed_and_looks_outward() {
    let things = &Crowd::Triangles.sizes()[3];
    assert_eq!(things.len(), 20 * 8 * 8);
    let place = |corner: [f64; 3]| corner.map(|c| (c * 1e9).round() as i64);
    let mut edges: HashMap<[[i64; 3]; 2], i32> = HashMap::new();
    for thing in things {
        let Thing::Triangle(corners) = thing else { panic!("{thing:?}") };
        let [a, b, c] = corners;
        let [e, f] = [b, c].map(|to| [0, 1, 2].map(|i| to[i] - a[i]));
        let normal = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
        assert!(normal.iter().zip(a).map(|(n, a)| n * a).sum::<f64>() > 0.0);
        for (from, to) in [(a, b), (b, c), (c, a)] {
            *edges.entry([place(*from), place(*to)]).or_default() += 1;
        }
    }
    // Each edge is run along once in each sense.
    assert!(edges.iter().all(|([from, to], count)| *count == 1 && edges.contains_key(&[*to, *from])));
}

#[test]
fn things_lie_in_their_boxes_and_crowds_in_a_cube() {
    for crowd in Crowd::ALL {
        for things in crowd.sizes().iter().filter(|things| (50..2000).contains(&things.len())) {
            for thing in things {
                let (bounds, own) = (Bounds::of_shape(&thing.shape::<f64>()).unwrap(), thing.bounds());
                assert!(bounds.low.iter().zip(own.low).all(|(a, b)| (a - b).abs() < 1e-12), "{thing:?}");
                assert!(bounds.high.iter().zip(own.high).all(|(a, b)| (a - b).abs() < 1e-12), "{thing:?}");
                assert!(own.largest() < 1.2, "{thing:?}");
            }
        }
    }
}

#[test]
fn a_tally_counts_what_is_done_with_it_and_computes_as_f64_does() {
    let (a, b) = (Tally::from_i32(3), Tally::HALF);
    let before = Tally::operations();
    let result = a * b + Tally::ONE - a.ratio(b) - Scalar::sqrt(a + Tally::ONE);
    assert_eq!(Tally::operations() - before, 7);
    assert_eq!(result, Tally::from_i32(-11) * b);
}

#[test]
fn the_command_prints_every_kind_and_draws_a_diagram() {
    let desk = Desk::new("hierarchies");
    let output = desk.run("hierarchies --most 100 -o growth.png");
    assert!(output.status.success(), "{output:?}");
    let text = stdout(&output);
    for accel in Accel::ALL {
        for things in [1, 10, 20, 80, 100] {
            assert!(text.contains(&format!("| {things} | {} |", accel.name())), "{things} {accel:?}: {text}");
        }
    }
    assert!(!text.contains("\n| 320 |"), "{text}");
    let (pixels, [columns, rows]) = read(&desk.0.join("growth.png"));
    assert!(columns > 800 && rows > 300);
    let colors: std::collections::HashSet<_> = pixels.into_iter().collect();
    assert!(colors.len() > 20, "a diagram of {} colours", colors.len());
}

#[test]
fn a_kind_that_there_is_not_is_refused() {
    let desk = Desk::new("hierarchies-refused");
    assert_refused(&desk, "hierarchies --kind bsp", &["bsp", "octree"]);
    assert_refused(&desk, "hierarchies --chip m7", &["m7", "m4f, m3, m0+"]);
    assert_refused(&desk, "hierarchies --chip m3 --most 10", &["--most", "cannot be used"]);
    assert_refused(&desk, "hierarchies --most 1 -o no/such/place.png", &["no/such/place.png"]);
}
