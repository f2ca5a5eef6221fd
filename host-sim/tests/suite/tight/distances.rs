//! Distances: those of small numbers are those of `f64`.

use crate::hostile::dice::Dice;
use host_sim::rounded::Rounded;
use scanray::ray::{Interval, Ray};
use scanray::{Cone, Cuboid, Fixed, Intersect, Shape, Sphere, Triangle, Vec3};

/// Answers a value that every number holds to the last digit.
fn held<S: Rounded>(value: f64) -> S {
    S::round((value * 16_384.0).round() / 16_384.0)
}

fn vector<S: Rounded>(place: [f64; 3]) -> Vec3<S> {
    Vec3::from_array(place.map(held))
}

/// Makes a body around the origin, of a size.
pub fn body<S: Rounded>(dice: &mut Dice, size: f64) -> Shape<S> {
    let [a, b, c] = [0; 3].map(|_| std::array::from_fn::<f64, 3, _>(|_| size * (2.0 * dice.share() - 1.0)));
    let radius = |share: f64| held(size * (0.2 + 0.8 * share));
    let shares = [dice.share(), dice.share()];
    match dice.below(4) {
        0 => Shape::Sphere(Sphere::new(Vec3::ZERO, radius(shares[0]))),
        1 => {
            let [low, high] = [-1.0, 1.0].map(|sign| vector(a.map(|x| sign * (x.abs() * 0.8 + 0.2 * size))));
            Shape::Cuboid(Cuboid::new(low, high))
        }
        2 => {
            // One corner on each axis: never too thin.
            let corners = [[a[0].abs() + 0.2 * size, 0.0, 0.0], [0.0, b[1].abs() + 0.2 * size, 0.0]];
            let [x, y] = corners.map(vector);
            Shape::Triangle(Triangle::new(x, y, vector([0.0, 0.0, -c[2].abs() - 0.2 * size])))
        }
        _ => {
            let base = vector([0.0, -0.8 * size, 0.1 * size]);
            let apex = vector([0.3 * size * shares[0], 0.8 * size, 0.0]);
            Shape::Cone(Cone::new(base, radius(shares[0]), apex, radius(shares[1])))
        }
    }
}

/// Answers how many rays meet something, and how many of them at another distance than in `f64`.
///
/// Every number holds bodies and points to the last digit: what differs is the computation.
fn off<S: Rounded>(name: &str, rays: usize) -> [usize; 2] {
    let mut dice = Dice::of(3);
    let (mut met, mut off) = (0, 0);
    for _ in 0..rays {
        let size = 10_f64.powf(dice.share() * 3.0 - 1.0);
        let mut again = dice.clone();
        let rounded = body::<S>(&mut dice, size);
        let exact = body::<f64>(&mut again, size);
        let place: [f64; 3] = std::array::from_fn(|_| 4.0 * size * (2.0 * dice.share() - 1.0));
        let aim: [f64; 3] = std::array::from_fn(|_| 0.4 * size * (2.0 * dice.share() - 1.0));
        let small = distance::<S>(&rounded, place, aim);
        let large = distance::<f64>(&exact, place, aim);
        let (Some(small), Some(large)) = (small, large) else { continue };
        met += 1;
        // Whether it is within a share of the exact distance, asked in the number itself.
        let slack = 1e-4 * large;
        off += usize::from(!(S::round(large - slack) <= small && small <= S::round(large + slack)));
    }
    println!("{name}: {off} of {met} distances are off by more than 1e-4 of them");
    [met, off]
}

fn distance<S: Rounded>(body: &Shape<S>, place: [f64; 3], aim: [f64; 3]) -> Option<S> {
    let eye = vector(place);
    let (direction, _) = (vector(aim) - eye).normalize()?;
    body.intersect(&Ray::new(eye, direction), &Interval::AHEAD).map(|crossing| crossing.t)
}

/// Asserts that all but one in ten thousand are right: where the eye all but touches a body, or a ray grazes a small
/// one, the steps of fixed point, 2^-20, count.
#[track_caller]
fn assert_right(rays: usize) {
    for [met, off] in [off::<f32>("f32", rays), off::<Fixed>("fixed", rays)] {
        assert!(met * 2 > rays, "{met} of {rays} rays meet something");
        assert!(off * 10_000 <= met, "{off} of {met}");
    }
}

#[test]
fn distances_are_right_to_a_ten_thousandth_but_for_one_in_ten_thousand() {
    assert_right(200_000);
}

#[test]
#[ignore = "a million rays take five times as long"]
fn of_a_million_distances_all_but_one_in_ten_thousand_are_right() {
    assert_right(1_000_000);
}
