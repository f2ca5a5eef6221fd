use super::{Picture, Proof, Sums};
use crate::scenes;
use std::fmt::Write;

/// Writes proofs as tables in Markdown: what was found of each chip and number, and the stack of each scene.
pub fn table(proofs: &[Proof], sums: &Sums) -> String {
    let mut text = String::from(
        "| chip    | number | code bytes | panics | pictures | unlike the host's | one ray a pixel: stack | by | any other way: stack | by |\n\
         |---------|--------|-----------:|-------:|---------:|------------------:|-----------------------:|----|---------------------:|----|\n",
    );
    for proof in proofs {
        let Proof { chip, number, code, panics, pictures } = proof;
        let unlike = sums.differences(number.name(), pictures).len();
        let [plain, other] = proof.deepest().map(|picture| {
            picture.map_or(String::new(), |Picture { scene, way, stack, .. }| {
                format!("{stack} | {scene}, {way}")
            })
        });
        // Writing to a string never fails.
        let _ = writeln!(
            text,
            "| {:7} | {:6} | {code:10} | {:6} | {:8} | {unlike:17} | {plain} | {other} |",
            chip.name,
            number.name(),
            panics.len(),
            pictures.len(),
        );
    }
    text + "\n" + &stacks(proofs)
}

/// Writes the bytes of stack that each scene takes beside what the caller holds: with one ray a pixel, and in the other
/// way that takes the most.
fn stacks(proofs: &[Proof]) -> String {
    let mut text = String::from("| stack beside workspace, row and renderer |");
    for Proof { chip, number, .. } in proofs {
        let _ = write!(text, " {} {} |", chip.name, number.name());
    }
    let _ = writeln!(text, "\n|---|{}", "--:|".repeat(proofs.len()));
    for entry in scenes::all() {
        let _ = write!(text, "| {} |", entry.name());
        for Proof { pictures, .. } in proofs {
            let most = |plain| {
                let alike = pictures.iter().filter(|picture| picture.is_plain() == plain);
                let of_scene = alike.filter(|picture| picture.scene == entry.name());
                of_scene.map(|picture| picture.stack).max().unwrap_or(0)
            };
            let _ = write!(text, " {} / {} |", most(true), most(false));
        }
        text.push('\n');
    }
    text
}
