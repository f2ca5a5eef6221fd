use super::{Proof, Sums};
use crate::scenes;
use std::fmt::Write;

/// Writes proofs as tables in Markdown: what was found of each chip and number, and the stack of each scene.
pub fn table(proofs: &[Proof], sums: &Sums) -> String {
    let mut text = String::from(
        "| chip    | number | code bytes | panics | pictures | unlike the host's | workspace | deepest stack | beside it | by\n",
    );
    text.push_str("|---------|--------|-----------:|-------:|---------:|------------------:|----------:|--------------:|----------:|---|\n");
    for proof in proofs {
        let Proof { chip, number, code, panics, workspace, pictures } = proof;
        let unlike = sums.differences(number.name(), pictures).len();
        let (stack, by) =
            proof.deepest().map_or((0, String::new()), |p| (p.stack, format!("{}, {}", p.scene, p.way)));
        // Writing to a string never fails.
        let _ = writeln!(
            text,
            "| {:7} | {:6} | {code:10} | {:6} | {:8} | {unlike:17} | {workspace:9} | {stack:13} | {:9} | {by} |",
            chip.name,
            number.name(),
            panics.len(),
            pictures.len(),
            stack.saturating_sub(*workspace),
        );
    }
    text + "\n" + &stacks(proofs)
}

/// Writes the bytes of stack beside the workspace that each scene takes in the way that takes the most.
fn stacks(proofs: &[Proof]) -> String {
    let mut text = String::from("| stack beside the workspace |");
    for Proof { chip, number, .. } in proofs {
        let _ = write!(text, " {} {} |", chip.name, number.name());
    }
    let _ = writeln!(text, "\n|---|{}", "--:|".repeat(proofs.len()));
    for entry in scenes::all() {
        let _ = write!(text, "| {} |", entry.name());
        for Proof { workspace, pictures, .. } in proofs {
            let of_scene = pictures.iter().filter(|picture| picture.scene == entry.name());
            let most = of_scene.map(|picture| picture.stack.saturating_sub(*workspace)).max().unwrap_or(0);
            let _ = write!(text, " {most} |");
        }
        text.push('\n');
    }
    text
}
