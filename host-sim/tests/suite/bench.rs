//! Speed and size are exact, so that what was measured before is a test.

use host_sim::bench::{Choice, Snapshot, measure};
use std::process::Command;

/// Measures a sample: `cargo sim bench` measures all.
#[test]
#[ignore = "needs the firmware's targets, qemu-system-arm and node with rp2040js (run by .ci/run)"]
fn a_sample_with_every_scene_costs_what_it_did_when_somebody_looked() {
    let choice = Choice { sample: true, ..Choice::default() };
    let rows = measure(choice, |what| eprintln!("{what}")).unwrap_or_else(|failure| panic!("{failure}"));
    let complaints = kept().complaints(&rows);
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn figures_are_kept_of_every_scene_on_every_chip_in_every_mode_and_of_nothing_else() {
    assert_eq!(kept().strangers(&Choice::default().cases()), [""; 0]);
}

fn kept() -> Snapshot {
    Snapshot::read().unwrap_or_else(|failure| panic!("{failure}"))
}

#[test]
fn an_unknown_chip_is_answered_with_the_names_of_those_there_are() {
    let output = Command::new(env!("CARGO_BIN_EXE_scanray")).args(["bench", "--chip", "m7"]).output();
    let output = output.expect("the command starts");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("the chips are m4f, m3, m0+"), "{said}");
}
