use super::Error;
use crate::scenes;
use std::io::Write;

/// Prints the gallery: name, size, what it shows.
pub(super) fn run(out: &mut impl Write) -> Result<(), Error> {
    let width = scenes::all().map(|entry| entry.name().len()).max().unwrap_or(0);
    for entry in scenes::all() {
        let [columns, rows] = entry.double.size;
        writeln!(out, "{:width$}  {columns}x{rows}  {}", entry.name(), entry.double.about)?;
    }
    Ok(())
}
