use super::args::WalksArgs;
use super::{Error, report};
use crate::{png, walks};
use std::io::Write;

/// Draws the cells that discrete walks visit.
pub(super) fn run(args: &WalksArgs, out: &mut impl Write) -> Result<(), Error> {
    let path = &args.output;
    png::write(path, &walks::sheet()).map_err(|error| Error::Write(path.clone(), error))?;
    Ok(report::line(out, "file", path.display())?)
}
