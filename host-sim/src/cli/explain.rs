use super::Error;
use super::look::{Curve, depth, scene, size};
use super::parse::judged;
use crate::dither::Method;
use crate::explain::Explanation;
use crate::panel::Panel;
use crate::shot::{Number, Shot};
use clap::Args;
use std::io::Write;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray explain three-spheres 160 120\n  \
    scanray explain glass 120 110 --number fixed --panel mono\n  \
    scanray explain mirror-levels 150 90 --svg tree.svg\n  \
    scanray explain glass 120 110 --dot | dot -Tpng -o tree.png\n\n\
    Rays are named as in drawings of their tree: R1 comes from the eye, R2 and so on from mirrors, T1 and so\n\
    on go through glass, L1 and so on ask for lights. `off` is the largest distance from the reference.")]
pub(super) struct ExplainArgs {
    /// Scene of the gallery, which `scanray list` names, or a file FILE.ron, FILE.nff or FILE.obj
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// Column of the pixel, from 0 at the left
    #[arg(value_name = "X")]
    pub x: u32,
    /// Row of the pixel, from 0 at the top
    #[arg(value_name = "Y")]
    pub y: u32,
    /// Explain it in this number only: f32, fixed or exact [default: f32 and fixed]
    #[arg(long, value_parser = judged)]
    pub number: Option<Number>,
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
    /// Print the tree of rays as a graph for Graphviz and nothing else
    #[arg(long)]
    pub dot: bool,
    /// Draw the tree of rays into a file
    #[arg(long, value_name = "FILE.svg")]
    pub svg: Option<PathBuf>,
}

impl ExplainArgs {
    /// Answers the shot that is asked for.
    fn shot(&self) -> Result<Shot, Error> {
        let mut shot = Shot::new(scene(&self.scene)?);
        shot.panel = self.panel;
        shot.size = self.size.unwrap_or(shot.size);
        shot.depth = self.depth.unwrap_or(shot.depth);
        shot.transfer = self.transfer.map_or(shot.transfer, Curve::transfer);
        shot.dither = self.dither.map_or(shot.dither, Method::dither);
        Ok(shot)
    }
}

/// Tells ray by ray how the light of a pixel comes about.
pub(super) fn run(args: &ExplainArgs, out: &mut impl Write) -> Result<(), Error> {
    let (shot, pixel) = (args.shot()?, [args.x, args.y]);
    if pixel[0] >= shot.size[0] || pixel[1] >= shot.size[1] {
        return Err(Error::NoSuchPixel { pixel, size: shot.size });
    }
    let numbers = args.number.map_or(vec![Number::F32, Number::Fixed], |number| vec![number]);
    let explained = Explanation::new(shot, &numbers, pixel);
    let explained = explained.map_err(|refusal| Error::refused(&shot.scene, refusal))?;
    if let Some(path) = &args.svg {
        std::fs::write(path, explained.svg()).map_err(|error| Error::Write(path.clone(), error))?;
    }
    if args.dot {
        return Ok(out.write_all(explained.dot().as_bytes())?);
    }
    write!(out, "{explained}")?;
    Ok(())
}
