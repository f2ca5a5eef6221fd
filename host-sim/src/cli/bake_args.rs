use crate::bake::Accel;
use crate::model::Options;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray bake model.obj -o model.rs --number fixed\n  \
    scanray bake model.obj --smooth 40 --floor --flash 256K\n  \
    scanray bake scenes/temple.ron -o temple.rs\n\n\
    docs/baking.md says what of a file is understood, and how a program takes the source.")]
pub(super) struct BakeArgs {
    /// Model FILE.obj, scene FILE.ron, or a scene of the gallery
    #[arg(value_name = "FILE")]
    pub scene: String,
    /// File to write the source to, `-` for the terminal [default: FILE.rs in the current directory]
    #[arg(short, long, value_name = "FILE.rs")]
    pub output: Option<PathBuf>,
    /// Number the program computes in
    #[arg(long, value_enum, default_value = "f32")]
    pub number: BakedNumber,
    /// Hierarchy over the triangles of meshes [default: bvh] and over the objects of a scene [default: none]
    #[arg(long, value_enum)]
    pub accel: Option<Accel>,
    /// Refuse more data than these bytes, such as 2M or 256K
    #[arg(long, value_name = "BYTES", value_parser = bytes)]
    pub flash: Option<usize>,
    /// Round edges of a model that are less sharp than this angle and have no normals
    #[arg(long, value_name = "DEGREES", value_parser = degrees)]
    pub smooth: Option<f64>,
    /// Keep corners and normals of a model as they are, in 12 bytes each instead of 6 and 2
    #[arg(long)]
    pub exact: bool,
    /// Stand a model on a floor
    #[arg(long)]
    pub floor: bool,
}

/// Names a number that programs compute in.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum BakedNumber {
    /// For chips with a floating-point unit
    F32,
    /// For chips without one
    Fixed,
}

impl BakeArgs {
    /// Answers what goes for models only.
    pub fn options(&self) -> Options {
        Options {
            smooth: self.smooth,
            exact: self.exact,
            floor: self.floor,
            accel: self.accel.unwrap_or_default(),
        }
    }
}

/// Reads a number of bytes, of 1024 with K and of 1048576 with M.
fn bytes(text: &str) -> Result<usize, String> {
    let (digits, shift) = match text.as_bytes().last() {
        Some(b'k' | b'K') => (&text[..text.len() - 1], 10),
        Some(b'm' | b'M') => (&text[..text.len() - 1], 20),
        _ => (text, 0),
    };
    let bytes = digits.parse().ok().and_then(|count: usize| count.checked_mul(1 << shift));
    bytes.ok_or_else(|| "a size is a number of bytes, such as 65536, 256K or 2M".to_owned())
}

fn degrees(text: &str) -> Result<f64, String> {
    let degrees = text.parse().ok().filter(|degrees| (0.0..=180.0).contains(degrees));
    degrees.ok_or_else(|| "an angle is a number of degrees from 0 to 180".to_owned())
}
