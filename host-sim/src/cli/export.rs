use super::args::ExportArgs;
use super::look::scene;
use super::{Error, report};
use crate::scene_file::{describe, write};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Writes a scene as a file that says the same.
pub(super) fn run(args: &ExportArgs, out: &mut impl Write) -> Result<(), Error> {
    let entry = scene(&args.scene)?;
    let description = match entry.file {
        Some(file) => file.description().clone(),
        None => describe(entry.double)?,
    };
    let text = write(&description)?;
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}.ron", entry.name())));
    if path == Path::new("-") {
        return Ok(out.write_all(text.as_bytes())?);
    }
    std::fs::write(&path, text).map_err(|error| Error::Write(path.clone(), error))?;
    Ok(report::line(out, "file", path.display())?)
}
