//! Speed and size are exact, so that what was measured before is a test.

use host_sim::bench::{Choice, Snapshot, measure};

#[test]
#[ignore = "needs the firmware's targets, qemu-system-arm and node with rp2040js (run by .ci/run)"]
fn every_scene_costs_on_every_chip_what_it_did_when_somebody_looked() {
    let kept = Snapshot::read().unwrap_or_else(|failure| panic!("{failure}"));
    let rows =
        measure(Choice::default(), |what| eprintln!("{what}")).unwrap_or_else(|failure| panic!("{failure}"));
    let complaints = kept.complaints(&rows);
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}
