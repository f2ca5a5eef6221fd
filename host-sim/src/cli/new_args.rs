use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray new --list\n  \
    scanray new --board pico ../my-picture\n\n\
    The project depends on the sources that this program was built from; it has the wires in README.md,\n\
    the scene in src/scene.rs, and exact versions of all that it is built with.")]
pub(super) struct NewArgs {
    /// Board to write firmware for; --list names them
    #[arg(long, required_unless_present = "list")]
    pub board: Option<String>,
    /// Folder to make, which gives the crate its name
    #[arg(value_name = "FOLDER", required_unless_present = "list")]
    pub folder: Option<PathBuf>,
    /// Tell which boards there are: chip, panel, number, target, and what flashes them
    #[arg(long, conflicts_with_all = ["board", "folder", "published"])]
    pub list: bool,
    /// Depend on scanray of crates.io
    #[arg(long)]
    pub published: bool,
}
