use super::{Bill, Map, What};
use crate::explain::Names;
use std::fmt::Write;

/// Is how many bars a histogram has, and how long the longest is.
const BARS: u64 = 12;
const LONGEST: usize = 40;

/// Answers a histogram in text: how many pixels take how much.
pub fn bars(map: &Map, what: What) -> String {
    let values: Vec<u64> = map.pixels.iter().map(|bill| what.of(bill)).collect();
    let most = values.iter().copied().max().unwrap_or(0);
    let width = (most + 1).div_ceil(BARS);
    let mut counts = vec![0_usize; (most / width + 1) as usize];
    values.iter().for_each(|value| counts[(value / width) as usize] += 1);
    let tallest = counts.iter().copied().max().unwrap_or(1).max(1);
    let mut text = format!("  {:>19}  {:>7}\n", what.name(), "pixels");
    for (from, count) in (0..).step_by(width as usize).zip(&counts) {
        let to = from + width - 1;
        let range = if width == 1 { from.to_string() } else { format!("{from} to {to}") };
        // Where there is a pixel there is a mark.
        let bar = "#".repeat((count * LONGEST).div_ceil(tallest));
        let share = 100.0 * *count as f64 / values.len().max(1) as f64;
        let _ = writeln!(text, "  {range:>19}  {count:>7} {share:5.1} %  {bar}");
    }
    text
}

/// Answers a table of the pixels that take most, the dearest first, with what they see and where it goes.
pub fn dearest(map: &Map, what: What, names: &Names, count: usize) -> String {
    let mut order: Vec<(usize, &Bill)> = map.pixels.iter().enumerate().collect();
    order.sort_by_key(|(place, bill)| (std::cmp::Reverse(what.of(bill)), *place));
    let heads =
        ["pixel", "rays", "shadow", "reflect", "refract", "shapes", "operations", "x", "/", "root", "pow"];
    let instructions = map.pixels.first().and_then(|bill| bill.instructions).map(|_| "instructions");
    let heads: Vec<String> = heads.into_iter().chain(instructions).map(str::to_owned).collect();
    let mut text = line(&heads, "sees");
    for (place, bill) in order.into_iter().take(count) {
        let columns = map.size[0].max(1) as usize;
        let (rays, operations) = (bill.rays, bill.operations);
        let numbers = [
            rays.total(),
            rays.shadow,
            rays.reflection,
            rays.refraction,
            bill.shapes,
            operations.total(),
            operations.products,
            operations.quotients,
            operations.roots,
            operations.powers,
        ];
        let pixel = format!("{},{}", place % columns, place / columns);
        let cells: Vec<String> = [pixel]
            .into_iter()
            .chain(numbers.into_iter().chain(bill.instructions).map(|n| n.to_string()))
            .collect();
        text += &line(&cells, &format!("{}: {}", names.object(bill.sees.map(usize::from)), why(bill)));
    }
    text
}

fn line(cells: &[String], last: &str) -> String {
    const WIDTHS: [usize; 12] = [9, 6, 7, 8, 8, 8, 11, 8, 6, 6, 6, 13];
    let cells: String = cells.iter().zip(WIDTHS).map(|(cell, width)| format!("{cell:>width$}")).collect();
    format!("  {cells}  {last}\n")
}

/// Says where most of a pixel's work comes from.
fn why(bill: &Bill) -> String {
    let rays = bill.rays;
    let onward = rays.reflection + rays.refraction;
    let asked = bill.shapes as f64 / rays.total().max(1) as f64;
    let cause = if rays.refraction > 0 {
        format!("glass splits it into {} rays", onward + rays.primary)
    } else if onward > 0 {
        format!("{} on its way", some(onward, "mirror"))
    } else if rays.shadow > 0 {
        format!("{} asked for", some(rays.shadow, "light"))
    } else {
        "one ray and no light".to_owned()
    };
    format!("{cause}, {asked:.1} shapes a ray")
}

/// Answers how many things there are, one at least, in words.
fn some(count: u64, thing: &str) -> String {
    if count == 1 { format!("a {thing}") } else { format!("{count} {thing}s") }
}
