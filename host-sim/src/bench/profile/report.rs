use super::Profile;
use std::collections::BTreeMap;
use std::fmt::{Display, Write};

/// Counts the functions that are worth a line.
const DEAREST: usize = 16;

/// Writes a profile as tables in Markdown.
pub fn report(profile: &Profile) -> String {
    let Profile { of, rows, pixels, stages, shapes, functions } = profile;
    let all = stages.values().sum::<u64>();
    let per_pixel = all as f64 / *pixels as f64;
    let mut text = format!("{of}: {per_pixel:.1} instructions a pixel, counted in {rows} rows\n\n");
    part(&mut text, "stage", sorted(stages), profile, all);
    part(&mut text, "shape", sorted(shapes), profile, all);
    part(&mut text, "function", sorted(functions).into_iter().take(DEAREST).collect(), profile, all);
    text
}

/// Answers what there is, the dearest first.
fn sorted<K: Display>(counts: &BTreeMap<K, u64>) -> Vec<(String, u64)> {
    let mut sorted: Vec<_> = counts.iter().map(|(key, count)| (key.to_string(), *count)).collect();
    sorted.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    sorted
}

fn part(text: &mut String, head: &str, lines: Vec<(String, u64)>, profile: &Profile, all: u64) {
    let width = lines.iter().map(|(name, _)| name.chars().count()).chain([head.len()]).max().unwrap_or(0);
    // Writing to a string never fails.
    let _ = writeln!(text, "| {head:width$} | instr/px |  share |");
    let _ = writeln!(text, "|{}|---------:|-------:|", "-".repeat(width + 2));
    for (name, count) in lines {
        let per_pixel = count as f64 / profile.pixels as f64;
        let share = 100.0 * count as f64 / all as f64;
        let _ = writeln!(text, "| {name:width$} | {per_pixel:8.1} | {share:4.1} % |");
    }
    text.push('\n');
}
