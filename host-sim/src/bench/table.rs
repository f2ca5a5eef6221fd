use super::Row;
use super::peers::Peer;
use std::fmt::Write;

const HEAD: [&str; 12] = [
    "scene",
    "chip",
    "number",
    "mode",
    "instr/px",
    "cycles/px",
    "peer's instr/px",
    "flash",
    "RAM",
    "stack",
    "PSNR dB",
    "whole dB",
];

/// Counts the columns of words; figures follow, to the right.
const WORDS: usize = 4;

/// Writes rows as a table in Markdown, with what its columns mean.
pub fn table(rows: &[Row]) -> String {
    let mut lines: Vec<[String; 12]> = vec![HEAD.map(str::to_owned)];
    lines.extend(rows.iter().map(cells));
    let widths: [usize; 12] =
        std::array::from_fn(|i| lines.iter().map(|cells| cells[i].chars().count()).max().unwrap_or(0));
    let mut text = String::new();
    for (n, cells) in lines.iter().enumerate() {
        write_line(&mut text, cells, &widths);
        if n == 0 {
            write_rule(&mut text, &widths);
        }
    }
    text + "\n" + &caption(rows)
}

fn write_line(text: &mut String, cells: &[String; 12], widths: &[usize; 12]) {
    for (i, (cell, width)) in cells.iter().zip(widths).enumerate() {
        // Writing to a string never fails.
        let _ = if i < WORDS { write!(text, "| {cell:width$} ") } else { write!(text, "| {cell:>width$} ") };
    }
    text.push_str("|\n");
}

fn write_rule(text: &mut String, widths: &[usize; 12]) {
    for (i, width) in widths.iter().enumerate() {
        let end = if i < WORDS { '-' } else { ':' };
        let _ = write!(text, "|{}{end}", "-".repeat(width + 1));
    }
    text.push_str("|\n");
}

fn cells(row: &Row) -> [String; 12] {
    let dash = || "-".to_owned();
    let peer = Peer::fastest(&row.scene, &row.chip).map_or_else(dash, |peer| peer.on(&row.chip).to_string());
    [
        row.scene.clone(),
        row.chip.clone(),
        row.number.clone(),
        row.mode.clone(),
        format!("{:.1}", row.instr_per_px),
        row.cycles_per_px.map_or_else(dash, |cycles| format!("{cycles:.1}")),
        peer,
        row.text_bytes.to_string(),
        row.ram_bytes.to_string(),
        row.stack_bytes.to_string(),
        format!("{:.2}", row.psnr_db),
        format!("{:.2}", row.psnr_all_db),
    ]
}

fn caption(rows: &[Row]) -> String {
    let mut text = String::from(
        "Whole frames of 320x240 pixels in Rgb565, a call of `render_row` for each row. Instructions are those executed\n\
         on QEMU's MPS2 boards; flash, static RAM and stack are bytes of the whole image, which holds that scene alone.\n\
         PSNR is taken from the f64 reference in 8 bits a channel, away from silhouettes and of the whole picture. The\n\
         peer's figure is that of the fastest tracer published for the scene and chip.\n",
    );
    let strides = rows.iter().filter(|row| row.cycles_per_px.is_some()).map(|row| row.stride);
    if let Some((least, most)) = strides.clone().min().zip(strides.max()) {
        let of = match (least, most) {
            (1, 1) => "in whole frames".to_owned(),
            (a, b) if a == b => format!("in one row of {a}"),
            (a, b) => format!("in one row of {a} to {b}"),
        };
        let _ = writeln!(
            text,
            "Cycles are instructions times the cycles of one on rp2040js, an emulated RP2040 without flash\n\
             waits, counted {of}."
        );
    }
    for (scene, name) in peers_of(rows) {
        let _ = writeln!(text, "Peer of {scene}: {name}.");
    }
    text
}

/// Answers the scenes with the names of their fastest peers.
fn peers_of(rows: &[Row]) -> Vec<(&str, &'static str)> {
    let mut found: Vec<(&str, &'static str)> = vec![];
    for row in rows {
        let peer = Peer::fastest(&row.scene, &row.chip).map(|peer| (row.scene.as_str(), peer.name));
        found.extend(peer.filter(|peer| !found.contains(peer)));
    }
    found
}
