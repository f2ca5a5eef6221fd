//! Scenes that nobody would make: whatever they hold, they are refused by name or drawn.
//!
//! A scene has a number, and is the same each time: all its parts are thrown from it, of all shapes, materials,
//! lights, skies, cameras and settings, with values from the ends of the numbers ([`values`]). None may panic,
//! with overflow checks on; each pixel is written once; the rays of a picture are as many as its depth allows.
//!
//! `cargo test -p host-sim --test suite hostile -- --ignored --nocapture` tries a million, or as many as
//! `SCANRAY_SCENES` says, and prints what became of them.

mod bodies;
mod canvas;
pub mod dice;
mod draw;
mod hierarchies;
mod liar;
mod look;
mod scene;
mod shelf;
mod surfaces;
mod tally;
mod values;
mod watch;

use dice::Dice;
use host_sim::scenes::HostNumber;
use rayon::prelude::*;
use scanray::Fixed;
use shelf::Shelf;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};
use tally::Tally;

/// Is the longest that a scene may take: a thousand times what one of them does.
const PATIENCE: Duration = Duration::from_secs(20);

/// Makes and draws the scenes of these numbers and counts what became of them.
fn run<S: HostNumber>(name: &'static str, numbers: std::ops::Range<u64>) -> Tally {
    let shelf = Shelf::<S>::stocked(&mut Dice::of(0));
    let try_one = |number: u64| {
        let start = Instant::now();
        let draw = || catch_unwind(AssertUnwindSafe(|| draw::scene(&shelf, &mut Dice::of(number))));
        let end = watch::timed(name, number, PATIENCE, draw);
        Tally::of(number, &end, start.elapsed())
    };
    numbers.into_par_iter().map(try_one).reduce(Tally::default, Tally::and)
}

#[track_caller]
fn assert_sound(tally: &Tally) {
    assert!(tally.panicked.is_empty(), "{tally}");
    assert!(tally.drawn * 10 > tally.scenes, "few are drawn: {tally}");
    assert!(tally.refused.len() >= 15, "few faults are met: {tally}");
    assert!(tally.slowest.0 < PATIENCE, "{tally}");
}

#[test]
fn any_scene_in_f32_is_refused_or_drawn() {
    assert_sound(&run::<f32>("f32", 0..4000));
}

#[test]
fn any_scene_in_fixed_point_is_refused_or_drawn() {
    assert_sound(&run::<Fixed>("fixed", 0..4000));
}

#[test]
#[ignore = "a million scenes take a quarter of a minute (run by .ci/run)"]
fn a_million_scenes_are_refused_or_drawn() {
    let asked = std::env::var("SCANRAY_SCENES").ok().and_then(|text| text.parse().ok());
    let half = asked.unwrap_or(1_000_000_u64) / 2;
    for (name, run) in [("f32", run::<f32> as fn(&'static str, _) -> Tally), ("fixed", run::<Fixed>)] {
        let tally = run(name, 0..half);
        println!("{name}: {tally}");
        assert_sound(&tally);
    }
}
