//! Speed and size are exact, so that what was measured before is a test.

use host_sim::bake::Accel;
use host_sim::bench::{Chip, Choice, Snapshot, cost, measure};
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
#[ignore = "needs the firmware's targets and qemu-system-arm (run by .ci/run)"]
fn with_each_kind_of_hierarchy_a_chip_draws_the_hosts_picture_in_a_fraction_of_the_work() {
    let chip = Chip::find("m3").expect("a chip");
    // A picture that is not the host's is a failure.
    let [bvh, kd, octree, grid, none] =
        Accel::ALL.map(|accel| cost(chip, accel).unwrap_or_else(|failure| panic!("{failure}")));
    for tree in [bvh, kd, octree, grid] {
        assert!(10.0 * tree.instr_per_px < none.instr_per_px, "{tree:?}, and {none:?}");
        assert!(bvh.bytes_each <= tree.bytes_each, "{tree:?} is smaller than a tree of boxes");
    }
}

#[test]
fn an_unknown_chip_is_answered_with_the_names_of_those_there_are() {
    let output = Command::new(env!("CARGO_BIN_EXE_scanray")).args(["bench", "--chip", "m7"]).output();
    let output = output.expect("the command starts");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("the chips are m4f, m3, m0+"), "{said}");
}
