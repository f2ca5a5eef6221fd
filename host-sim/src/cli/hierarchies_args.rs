use crate::bake::Accel;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray hierarchies -o growth.png\n  \
    scanray hierarchies --kind bvh --most 1000")]
pub(super) struct HierarchiesArgs {
    /// Measure this kind only
    #[arg(long, value_enum)]
    pub kind: Option<Accel>,
    /// Measure crowds of no more things than this
    #[arg(long, value_name = "N", default_value = "100000")]
    pub most: usize,
    /// File for a diagram of the work of a ray against the number of things
    #[arg(short, long, value_name = "FILE.png")]
    pub output: Option<PathBuf>,
}
