use super::parse::chip;
use crate::bake::Accel;
use crate::bench::Chip;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray hierarchies -o growth.png\n  \
    scanray hierarchies --kind bvh --most 1000\n  \
    scanray hierarchies --chip m0+\n\n\
    With `--chip` it builds firmware from the sources of this project and needs what `bench` needs.")]
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
    /// Count what the teapot costs on an emulated chip instead: m4f, m3 or m0+
    #[arg(long, value_parser = chip, conflicts_with_all = ["most", "output"])]
    pub chip: Option<&'static Chip>,
}
