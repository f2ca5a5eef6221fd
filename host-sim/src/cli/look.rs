use super::Error;
use super::rays::Rays;
use crate::dither::Method;
use crate::files::Disk;
use crate::model::{Options, entry};
use crate::nff;
use crate::obj;
use crate::panel::Panel;
use crate::picture::{MAX_DEPTH, MAX_SIDE};
use crate::scene_file::SceneFile;
use crate::scenes;
use crate::shot::{Approach, Number, Shot};
use crate::turn::Turn;
use clap::{Args, ValueEnum};
use scanray::Transfer;
use std::io::{self, Write};
use std::path::Path;

/// Is what a picture is to look like.
#[derive(Debug, Args)]
pub(super) struct Look {
    /// Scene of the gallery, which `scanray list` names, or a file FILE.ron, FILE.nff or FILE.obj
    #[arg(value_name = "SCENE", default_value = "simple")]
    pub scene: String,
    /// Number the picture is traced in
    #[arg(long, default_value = "f32")]
    pub number: Number,
    /// Columns and rows, such as 160x120 [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<[u32; 2]>,
    /// Colour format of the display
    #[arg(long, default_value = "rgb565")]
    pub panel: Panel,
    /// How many mirrors light may have met [default: the scene's]
    #[arg(long, value_name = "N", value_parser = depth)]
    pub depth: Option<u8>,
    /// How light becomes levels [default: the scene's]
    #[arg(long, value_enum)]
    pub transfer: Option<Curve>,
    /// How levels are rounded to those the panel has [default: the scene's]
    #[arg(long, value_name = "METHOD")]
    pub dither: Option<Method>,
    #[command(flatten)]
    pub rays: Rays,
    /// Who draws it: the ray tracer, or the z-buffer, which knows no quality and no depth
    #[arg(long, default_value = "trace")]
    pub approach: Approach,
    /// Step K of N of a turn around the point that the camera looks at
    #[arg(long, value_name = "K/N")]
    pub step: Option<Turn>,
}

impl Look {
    /// Answers the shot that is asked for.
    pub fn shot(&self) -> Result<Shot, Error> {
        let mut shot = Shot::new(scene(&self.scene)?);
        shot.number = self.number;
        shot.panel = self.panel;
        shot.size = self.size.unwrap_or(shot.size);
        shot.depth = self.depth.unwrap_or(shot.depth);
        shot.turn = self.step.unwrap_or(shot.turn);
        shot.transfer = self.transfer.map_or(shot.transfer, Curve::transfer);
        shot.dither = self.dither.map_or(shot.dither, Method::dither);
        shot.approach = self.approach;
        if self.approach == Approach::Trace {
            shot.quality = self.rays.quality();
        }
        Ok(shot)
    }
}

/// Finds a scene: one of the gallery, or that of a file; says on stderr what of a file is not drawn as it says.
pub(super) fn scene(name: &str) -> Result<scenes::Entry, Error> {
    match scenes::find(name) {
        Some(entry) => Ok(entry),
        None if obj::is_named(Path::new(name)) => {
            Ok(entry(&obj::plan(&Disk, Path::new(name), Options::default())?))
        }
        None if is_file(name) => {
            let entry = scenes::read(Path::new(name))?;
            for note in entry.file.map_or(&[][..], SceneFile::notes) {
                // If nobody reads it, the picture is the same.
                let _ = writeln!(io::stderr(), "{name}: {note}");
            }
            Ok(entry)
        }
        None => Err(Error::UnknownScene(name.to_owned())),
    }
}

/// Tells whether a name is that of a scene file.
fn is_file(name: &str) -> bool {
    name.ends_with(".ron") || nff::is_named(Path::new(name))
}

/// Reads columns and rows.
pub(super) fn size(text: &str) -> Result<[u32; 2], String> {
    let side = |text: &str| text.parse().ok().filter(|n| (1..=MAX_SIDE).contains(n));
    let sides = text.split_once(['x', 'X']).and_then(|(w, h)| Some([side(w)?, side(h)?]));
    sides.ok_or_else(|| {
        format!("a size is columns x rows, each from 1 to {MAX_SIDE}, written such as 320x240")
    })
}

pub(super) fn depth(text: &str) -> Result<u8, String> {
    let depth = text.parse().ok().filter(|depth| usize::from(*depth) <= MAX_DEPTH);
    depth.ok_or_else(|| format!("a depth is a number from 0 to {MAX_DEPTH}, such as 3"))
}

/// Names a transfer curve on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Curve {
    /// The sRGB curve, as panels and PNG files expect it
    Srgb,
    /// Levels proportional to light
    Linear,
}

impl Curve {
    /// Answers the curve itself.
    pub fn transfer(self) -> Transfer {
        match self {
            Self::Srgb => Transfer::Srgb,
            Self::Linear => Transfer::Linear,
        }
    }
}
