use super::args::ExportArgs;
use super::look::scene;
use super::{Error, report};
use crate::scene_file::{describe, write};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Writes a scene as a file that says the same, its images, meshes and voxels beside it.
pub(super) fn run(args: &ExportArgs, out: &mut impl Write) -> Result<(), Error> {
    let entry = scene(&args.scene)?;
    let mut description = match entry.file {
        Some(file) => file.description().clone(),
        None => describe(entry.double)?,
    };
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}.ron", entry.name())));
    let files = description.name_files(&path.file_stem().unwrap_or_default().to_string_lossy());
    let text = write(&description)?;
    if path == Path::new("-") {
        return if files.is_empty() {
            Ok(out.write_all(text.as_bytes())?)
        } else {
            Err(Error::FilesToTerminal)
        };
    }
    // These first: a scene file never names what is not there.
    for file in files {
        let path = path.with_file_name(file.name());
        file.write(&path).map_err(|error| Error::Write(path.clone(), error))?;
        report::line(out, file.kind(), path.display())?;
    }
    std::fs::write(&path, text).map_err(|error| Error::Write(path.clone(), error))?;
    Ok(report::line(out, "file", path.display())?)
}
