//! How the work of a ray grows with the number of things it may meet, by each kind of hierarchy.

mod crowd;
mod parts;
mod plot;
mod random;
mod tally;

pub use crowd::{Crowd, Thing};
pub use plot::plot;
pub use tally::{Operations, Tally};

use crate::bake::{Accel, Bounds, Built};
use crate::rounded::Rounded;
use random::Random;
use scanray::accel::Hierarchy;
use scanray::ray::{Interval, Ray};
use scanray::{Intersect, Shape, Vec3};
use std::time::{Duration, Instant};

/// Is how many rays are measured.
const RAYS: usize = 2000;

/// Is how often time is taken.
const TIMES: usize = 5;

/// Is how often things are asked without a hierarchy, at most: of many things fewer rays are then enough.
const ASKED: usize = 1 << 22;

/// Is what a hierarchy takes over one crowd.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// What the crowd is of.
    pub crowd: Crowd,
    /// The kind of hierarchy.
    pub accel: Accel,
    /// How many things there are.
    pub things: usize,
    /// Bytes in flash.
    pub bytes: usize,
    /// How long it took to build.
    pub build: Duration,
    /// How many things a ray asks, on average.
    pub asked: f64,
    /// Sums, products, quotients and roots of the number for a ray, those of the things that it asks included: not the
    /// whole numbers in which the tree of boxes asks its boxes.
    pub operations: f64,
    /// Time for a ray in `f32` on this computer.
    pub time: Duration,
}

/// Measures a kind of hierarchy over things: rays from all around look for the nearest.
///
/// A hierarchy holds 65535 things at most; of more each half has its own, and a ray asks one after the other.
pub fn measure(crowd: Crowd, things: &[Thing], accel: Accel) -> Sample {
    let parts = parts::parts(things);
    let begun = Instant::now();
    let built: Vec<Built> = parts.iter().map(|part| accel.build(&bounds(part))).collect();
    let build = begun.elapsed();
    let few = if accel == Accel::None { ASKED / things.len().max(1) } else { RAYS };
    let rays = rays(few.clamp(1, RAYS));
    let before = Tally::operations();
    let (asked, _) = look::<Tally>(&parts, &built, &rays);
    let operations = Tally::operations() - before;
    // The least of several: what else runs on the computer only adds to it.
    let times = (0..TIMES).map(|_| look::<f32>(&parts, &built, &rays).1);
    let time = times.min().unwrap_or_default();
    let share = |count: u64| count as f64 / rays.len() as f64;
    Sample {
        crowd,
        accel,
        things: things.len(),
        bytes: built.iter().map(Built::bytes).sum(),
        build,
        asked: share(asked),
        operations: share(operations),
        time: time / rays.len() as u32,
    }
}

/// Is where a ray begins and a point toward which it goes.
type Aim = [[f64; 3]; 2];

/// Answers rays from around a cube to points in it, the same ones every time.
fn rays(count: usize) -> Vec<Aim> {
    let mut random = Random::new();
    let mut next = || {
        let [from, to] = [random.point(), random.point()];
        let length = from.iter().map(|c| c * c).sum::<f64>().sqrt();
        [from.map(|c| 4.0 * c / length), to]
    };
    (0..count).map(|_| next()).collect()
}

fn bounds(things: &[Thing]) -> Vec<Bounds> {
    things.iter().map(Thing::bounds).collect()
}

/// Is things with the hierarchy over them, in a number.
type Group<S> = (Vec<Shape<S>>, &'static dyn Hierarchy<S>);

/// Looks for the nearest thing along each ray; answers how many were asked, and how long it took.
fn look<S: Rounded>(parts: &[Vec<Thing>], built: &[Built], rays: &[Aim]) -> (u64, Duration) {
    let group =
        |(part, built): (&Vec<Thing>, &Built)| (part.iter().map(Thing::shape).collect(), built.leak::<S>());
    let groups: Vec<Group<S>> = parts.iter().zip(built).map(group).collect();
    let point = |place: [f64; 3]| Vec3::from_array(place.map(S::round));
    let rays: Vec<Ray<S>> = rays
        .iter()
        .filter_map(|[from, to]| {
            let (from, to) = (point(*from), point(*to));
            Some(Ray::new(from, (to - from).normalize()?.0))
        })
        .collect();
    let begun = Instant::now();
    let asked = rays.iter().map(|ray| nearest(&groups, ray)).sum();
    (asked, begun.elapsed())
}

/// Looks for the nearest shape and answers how many were asked.
fn nearest<S: Rounded>(groups: &[Group<S>], ray: &Ray<S>) -> u64 {
    let (mut asked, mut interval) = (0, Interval::AHEAD);
    for (shapes, hierarchy) in groups {
        let ahead = interval;
        hierarchy.walk(ray, &ahead, &mut |number| {
            asked += 1;
            if let Some(crossing) = shapes[usize::from(number)].intersect(ray, &interval) {
                interval.far = crossing.t;
            }
            interval.far
        });
    }
    asked
}
