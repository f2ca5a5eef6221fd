//! The race against other renderers: it runs, and all of them draw the same pictures.
//!
//! Needs `povray` and `tachyon` (Debian: povray, tachyon). How fast anyone is is not tested here.

use std::process::{Command, Output};

fn race(arguments: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_scanray"))
        .args(arguments.split_whitespace())
        .output()
        .expect("it is built")
}

/// Answers the cells of a table's rows, its head left out.
fn rows(table: &str) -> Vec<Vec<&str>> {
    let rows = table.lines().filter(|line| line.starts_with('|')).skip(2);
    rows.map(|line| line.trim_matches('|').split('|').map(str::trim).collect()).collect()
}

#[test]
#[ignore = "needs povray and tachyon"]
fn all_programs_draw_both_scenes_and_their_pictures_agree() {
    let output = race("race --size 160x120 --runs 1");
    assert!(output.status.success(), "{output:?}");
    let table = String::from_utf8(output.stdout).expect("the table is text");
    print!("{table}");
    let rows = rows(&table);
    for scene in ["c-ray", "balls"] {
        for program in ["scanray", "povray", "tachyon"] {
            let found: Vec<_> = rows.iter().filter(|row| row[..2] == [scene, program]).collect();
            assert!(!found.is_empty(), "{program} did not draw {scene}:\n{table}");
            for row in found {
                let number = |cell: usize| row[cell].trim_end_matches(" %").parse::<f64>().expect("a number");
                let [seconds, psnr, over] = [3, 6, 7].map(number);
                assert!(seconds > 0.0 && psnr > 45.0 && over < 0.1, "{row:?}");
            }
        }
    }
}

#[test]
fn a_program_that_is_not_installed_is_named_with_its_package() {
    let nowhere = std::env::temp_dir().join("scanray-no-programs-here");
    let mut command = Command::new(env!("CARGO_BIN_EXE_scanray"));
    let output = command.args(["race", "--size", "16x12", "--runs", "1"]).env("PATH", nowhere).output();
    let output = output.expect("it is built");
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(output.stdout.is_empty(), "{output:?}");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("povray is not installed") && said.contains("apt-get install povray"), "{said}");
}
