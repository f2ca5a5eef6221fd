use super::Error;
use super::args::ListArgs;
use super::look::scene;
use crate::scenes::{self, Entry};
use std::io::Write;

/// Prints scenes, by default the gallery's: name, size, what it shows.
pub(super) fn run(args: &ListArgs, out: &mut impl Write) -> Result<(), Error> {
    let entries: Vec<Entry> = if args.scenes.is_empty() {
        scenes::all().collect()
    } else {
        args.scenes.iter().map(|name| scene(name)).collect::<Result<_, _>>()?
    };
    let width = entries.iter().map(|entry| entry.name().len()).max().unwrap_or(0);
    for entry in entries {
        let [columns, rows] = entry.double.size;
        writeln!(out, "{:width$}  {columns}x{rows}  {}", entry.name(), entry.double.about)?;
    }
    Ok(())
}
