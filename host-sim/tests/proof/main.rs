//! What is proven of the core: it cannot panic, and every chip draws the same bits.

use host_sim::proof::{Chip, Choice, Sums, planted, prove, table, turn};
use host_sim::shot::Number;

#[test]
fn the_host_draws_the_gallery_to_the_bit_as_it_did_when_somebody_looked() {
    let kept = Sums::read().unwrap_or_else(|failure| panic!("{failure}"));
    let changes = Sums::draw().changes(&kept);
    assert!(changes.is_empty(), "\n{}", changes.join("\n"));
}

#[test]
#[ignore = "needs the firmware's targets, qemu-system-arm and qemu-system-riscv32 (run by .ci/run)"]
fn no_chip_can_panic_and_all_draw_what_the_host_draws_on_a_shallow_stack() {
    let kept = Sums::read().unwrap_or_else(|failure| panic!("{failure}"));
    let proofs =
        prove(Choice::default(), |what| eprintln!("{what}")).unwrap_or_else(|failure| panic!("{failure}"));
    println!("{}", table(&proofs, &kept));
    let complaints: Vec<_> = proofs.iter().flat_map(|proof| proof.complaints(&kept)).collect();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
#[ignore = "needs the target thumbv7m-none-eabi (run by .ci/run)"]
fn planted_panics_are_found_and_named_with_their_callers() {
    let chip = Chip::find("m3").expect("a chip");
    let found = planted(chip, Number::Fixed).unwrap_or_else(|failure| panic!("{failure}"));
    let found: Vec<_> = found.iter().map(|panic| panic.to_string()).collect();
    for defect in ["index", "overflow", "division", "unwrap"] {
        let function = format!("planted::{defect}");
        let is_it = |chain: &&String| chain.contains(&function) && chain.ends_with("main < Reset");
        assert!(found.iter().any(|chain| is_it(&chain)), "{function} is not among\n{}", found.join("\n"));
    }
}

/// How often is up to `SCANRAY_TURNS`; an RP2040 would draw 27 turns in an hour.
#[test]
#[ignore = "needs the firmware's targets and qemu-system-arm (run by .ci/run)"]
fn a_camera_that_turns_for_long_comes_back_to_the_picture_it_began_with() {
    let turns = std::env::var("SCANRAY_TURNS").map_or(2, |turns| turns.parse().expect("a number of turns"));
    for (chip, number) in [("m4f", Number::F32), ("m3", Number::Fixed)] {
        let choice = Choice { chip: Chip::find(chip), number: Some(number) };
        for turns in
            turn(choice, turns, |what| eprintln!("{what}")).unwrap_or_else(|failure| panic!("{failure}"))
        {
            println!("{turns}");
            assert_eq!(turns.astray(), None, "{turns}");
        }
    }
}
