use super::look::{depth, scene, size};
use super::progress::Progress;
use super::render::take;
use super::{Error, report};
use crate::cost::{Bill, Map, Uncounted, What, bars, count, dearest, heat};
use crate::explain::Names;
use crate::panel::Panel;
use crate::png;
use crate::shot::{Refusal, Shot};
use clap::Args;
use std::io::Write;
use std::path::PathBuf;

/// Is how many of the dearest pixels are named.
const DEAREST: usize = 8;

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray cost glass\n  \
    scanray cost three-spheres --what operations -o operations.png\n  \
    scanray cost mirror-levels --depth 5 --size 160x120\n\n\
    Pixels are traced one by one in a number that counts what is done with it; what a row takes once, to find\n\
    which shapes its pixels can meet, is told apart. `scanray bench` counts instructions of chips.")]
pub(super) struct CostArgs {
    /// Scene of the gallery, which `scanray list` names, or a file FILE.ron, FILE.nff or FILE.obj
    #[arg(value_name = "SCENE", default_value = "simple")]
    pub scene: String,
    /// What is counted in the map, the histogram and the order of the table
    #[arg(long, default_value = "rays")]
    pub what: What,
    /// Columns and rows, such as 160x120 [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<[u32; 2]>,
    /// How many mirrors light may have met [default: the scene's]
    #[arg(long, value_name = "N", value_parser = depth)]
    pub depth: Option<u8>,
    /// File to write the map to [default: SCENE-cost.png in the current directory]
    #[arg(short, long, value_name = "FILE.png")]
    pub output: Option<PathBuf>,
}

/// Counts what each pixel takes, draws it as a map and tells where it goes.
pub(super) fn run(args: &CostArgs, out: &mut impl Write) -> Result<(), Error> {
    let mut shot = Shot::new(scene(&args.scene)?);
    shot.panel = Panel::Rgb888;
    shot.size = args.size.unwrap_or(shot.size);
    shot.depth = args.depth.unwrap_or(shot.depth);
    let picture = take(&shot)?.picture;
    let name = shot.scene.name();
    let map = counted(&shot)?;
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{name}-cost.png")));
    png::write(&path, &heat(&map, args.what, &picture)).map_err(|error| Error::Write(path.clone(), error))?;
    writeln!(out, "{name}: {}", shot.scene.double.about)?;
    totals(out, &map)?;
    writeln!(out, "\n{}", bars(&map, args.what))?;
    writeln!(out, "{}", dearest(&map, args.what, &Names::of(&shot.scene), DEAREST))?;
    Ok(report::line(out, "file", path.display())?)
}

fn counted(shot: &Shot) -> Result<Map, Error> {
    let mut progress = Progress::new(u64::from(shot.size[1]), format!("counting {}", shot.scene.name()));
    count(shot, |_| progress.step()).map_err(|uncounted| match uncounted {
        Uncounted::Core(error) => Error::refused(&shot.scene, Refusal::Core(error)),
        Uncounted::Scene(unsayable) => Error::Uncounted(unsayable),
    })
}

/// Prints what the picture takes in all.
fn totals(out: &mut impl Write, map: &Map) -> Result<(), Error> {
    let sum = |of: fn(&Bill) -> u64| map.pixels.iter().map(of).sum::<u64>();
    let a_pixel = |total: u64| total as f64 / map.pixels.len().max(1) as f64;
    let rays = [
        (sum(|bill| bill.rays.primary), "primary"),
        (sum(|bill| bill.rays.shadow), "shadow"),
        (sum(|bill| bill.rays.reflection), "reflected"),
        (sum(|bill| bill.rays.refraction), "refracted"),
    ];
    let rays = rays.map(|(count, kind)| format!("{:.2} {kind}", a_pixel(count)));
    report::line(out, "rays", format!("{} a pixel", rays.join(", ")))?;
    report::line(out, "shapes", format!("{:.2} asked a pixel", a_pixel(sum(|bill| bill.shapes))))?;
    let operations = [
        (sum(|bill| bill.operations.sums), "sums"),
        (sum(|bill| bill.operations.products), "products"),
        (sum(|bill| bill.operations.quotients), "quotients"),
        (sum(|bill| bill.operations.roots), "roots"),
        (sum(|bill| bill.operations.powers), "powers"),
    ];
    let operations = operations.map(|(count, kind)| format!("{:.1} {kind}", a_pixel(count)));
    report::line(out, "operations", format!("{} a pixel", operations.join(", ")))?;
    let rows: u64 = map.rows.iter().map(|bill| bill.operations.total()).sum();
    let beside = rows as f64 / map.rows.len().max(1) as f64;
    Ok(report::line(out, "rows", format!("{beside:.0} operations each beside its pixels"))?)
}
