use super::args::ExportArgs;
use super::look::scene;
use super::{Error, report};
use crate::scene_file::{describe, png_file, write};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Writes a scene as a file that says the same, its images beside it.
pub(super) fn run(args: &ExportArgs, out: &mut impl Write) -> Result<(), Error> {
    let entry = scene(&args.scene)?;
    let mut description = match entry.file {
        Some(file) => file.description().clone(),
        None => describe(entry.double)?,
    };
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}.ron", entry.name())));
    let images = description.name_images(&path.file_stem().unwrap_or_default().to_string_lossy());
    let text = write(&description)?;
    if path == Path::new("-") {
        return if images.is_empty() {
            Ok(out.write_all(text.as_bytes())?)
        } else {
            Err(Error::ImagesToTerminal)
        };
    }
    // The images first: a scene file never names what is not there.
    for image in images {
        let path = path.with_file_name(image.name);
        png_file::write(&path, &image.bitmap).map_err(|error| Error::Write(path.clone(), error))?;
        report::line(out, "image", path.display())?;
    }
    std::fs::write(&path, text).map_err(|error| Error::Write(path.clone(), error))?;
    Ok(report::line(out, "file", path.display())?)
}
