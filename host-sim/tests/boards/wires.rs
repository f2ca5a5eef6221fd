//! The wires of a board are told in three places: its README, the head of `board.rs`, and the code below it.

use crate::project::Project;
use host_sim::boards::{BOARDS, Source};

/// Answers the rows of the first table, without its head.
fn table<'t>(lines: impl Iterator<Item = &'t str>) -> Vec<[&'t str; 2]> {
    let rows = lines.skip_while(|line| !line.starts_with('|')).take_while(|line| line.starts_with('|'));
    let cells = |line: &'t str| -> [&'t str; 2] {
        let cells: Vec<_> = line.trim_matches('|').split('|').map(str::trim).collect();
        cells.try_into().unwrap_or_else(|_| panic!("two cells: {line}"))
    };
    rows.map(cells).skip(2).collect()
}

/// Answers how a pin of a table may be written in code.
fn written(pin: &str) -> [String; 4] {
    // "P16 (P1.02)" is the name on the board and that of the chip, by which the code calls it.
    let pin = pin.rsplit('(').next().unwrap_or(pin).trim_end_matches(')');
    let digits = pin.trim_start_matches("GPIO ");
    [
        format!("gpio{digits}.reconfigure"),
        format!("p.GPIO{digits}"),
        format!("p.PIN_{digits}"),
        pin.to_lowercase().replace('.', "_") + ".into_push_pull_output",
    ]
}

#[test]
fn the_readme_and_the_code_name_the_same_wires() {
    for board in &BOARDS {
        let texts = Project::new(board, &Source::here()).texts();
        let code = &texts["src/board.rs"];
        let head = code.lines().filter_map(|line| line.strip_prefix("//! "));
        let (said, coded) = (table(texts["README.md"].lines()), table(head));
        // Power is in the README alone. What the panel calls its pin may be explained in the code.
        let wires: Vec<_> = said.iter().filter(|[pin, _]| !pin.contains("GND")).collect();
        assert!(wires.len() >= 5 && wires.len() == coded.len(), "{}: {said:?} {coded:?}", board.name);
        for ([pin, _], [coded, _]) in wires.iter().zip(&coded) {
            assert_eq!(pin, coded, "{}", board.name);
        }
    }
}

/// The LM3S6965 has its panel on board, and its pins are bits of masks.
#[test]
fn every_pin_of_the_table_is_taken_in_the_code() {
    for board in BOARDS.iter().filter(|board| board.name != "lm3s6965evb") {
        let texts = Project::new(board, &Source::here()).texts();
        let code = &texts["src/board.rs"];
        for [pin, _] in table(code.lines().filter_map(|line| line.strip_prefix("//! "))) {
            let taken = written(pin).iter().any(|text| code.contains(text.as_str()))
                || code.contains(&format!("Some(b.{})", pin.to_lowercase()));
            assert!(taken, "{}: {pin}", board.name);
        }
    }
}

#[test]
fn every_constant_that_a_readme_says_to_change_is_in_the_code() {
    for board in &BOARDS {
        let texts = Project::new(board, &Source::here()).texts();
        let is_constant = |word: &&str| {
            word.len() > 3 && word.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_')
        };
        let named: Vec<_> = texts["README.md"].split('`').skip(1).step_by(2).filter(is_constant).collect();
        assert!(!named.is_empty(), "{}", board.name);
        for word in named {
            let written = format!("const {word}:");
            assert!(texts.values().any(|text| text.contains(&written)), "{}: {word}", board.name);
        }
    }
}
