use super::Error;
use super::args::BenchArgs;
use super::look::scene;
use super::progress::tell;
use crate::bench::{self, Choice, Snapshot};
use std::io::Write;

/// Measures scenes on emulated chips, prints a table or a profile.
pub(super) fn run(args: &BenchArgs, out: &mut impl Write) -> Result<(), Error> {
    let name = args.scene.as_deref().map(scene).transpose()?.map(|entry| entry.name());
    let choice = Choice { scene: name, chip: args.chip, sample: false };
    if args.profile {
        let profiles = bench::profile(choice, tell)?;
        let text: String = profiles.iter().map(bench::report).collect();
        return Ok(out.write_all(text.as_bytes())?);
    }
    let rows = bench::measure(choice, tell)?;
    if args.json {
        let text = serde_json::to_string_pretty(&rows).map_err(std::io::Error::from)?;
        writeln!(out, "{text}")?;
    } else {
        write!(out, "{}", bench::table(&rows))?;
    }
    if args.update {
        // A snapshot that cannot be read is made anew.
        let mut kept = Snapshot::read().unwrap_or_default();
        kept.update(&rows);
        let path = kept.write()?;
        tell(&format!("kept in {}", path.display()));
    }
    Ok(())
}
