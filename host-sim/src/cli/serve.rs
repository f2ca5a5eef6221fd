use super::{Error, report};
use crate::serve::{Server, Site, build};
use clap::Args;
use std::io::Write;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray serve\n  \
    scanray serve --port 8080\n  \
    scanray serve --out site\n\n\
    It builds the core from the sources of this project, for the target wasm32-unknown-unknown. Only\n\
    browsers of this computer can ask the server; the folder of `--out` goes on any web server.")]
pub(super) struct ServeArgs {
    /// Port to listen at on this computer; 0 takes any that is free
    #[arg(long, value_name = "N", default_value = "8000")]
    pub port: u16,
    /// Write the page to this folder instead, for any web server
    #[arg(long, value_name = "DIR", conflicts_with = "port")]
    pub out: Option<PathBuf>,
}

/// Serves the playground until the program is stopped, or writes it to a folder.
pub(super) fn run(args: &ServeArgs, out: &mut impl Write) -> Result<(), Error> {
    let site = Site::gather(&build::wasm()?)?;
    if let Some(folder) = &args.out {
        let bytes = site.write(folder)?;
        return Ok(report::line(out, "written", format!("{}, {bytes} bytes", folder.display()))?);
    }
    let server = Server::new(args.port)?;
    report::line(out, "playground", server.address())?;
    report::line(out, "stop", "Ctrl-C")?;
    out.flush()?;
    match server.run(site)? {}
}
