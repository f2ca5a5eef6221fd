use super::look::{depth, scene, size};
use super::parse::chip;
use super::progress::{Progress, tell};
use super::take::take;
use super::{Error, report};
use crate::bench::{Chip, SIZE, account};
use crate::cost::{Account, Bill, Map, Uncounted, What, bars, count, dearest, heat};
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
    scanray cost mirror-levels --depth 5 --size 160x120\n  \
    scanray cost teapot --chip m0+\n\n\
    Pixels are traced one by one in a number that counts what is done with it; what a row takes once, to find\n\
    which shapes its pixels can meet, is told apart.\n\n\
    With `--chip` it builds firmware from the sources of this project and runs it on that chip in an emulator, which\n\
    counts instructions: those of each row as it is drawn, and those of each pixel alone. It needs what `bench` needs.")]
pub(super) struct CostArgs {
    /// Scene of the gallery, which `scanray list` names, or a file FILE.ron, FILE.nff or FILE.obj
    #[arg(value_name = "SCENE", default_value = "simple")]
    pub scene: String,
    /// What is counted in the map, the histogram and the order of the table [default: rays; with a chip
    /// instructions]
    #[arg(long)]
    pub what: Option<What>,
    /// Count instructions too, of a picture of 320x240 on an emulated chip: m4f, m3 or m0+
    #[arg(long, value_parser = chip, required_if_eq("what", "instructions"), conflicts_with = "size")]
    pub chip: Option<&'static Chip>,
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
    shot.size = args.chip.map_or(args.size.unwrap_or(shot.size), |_| SIZE);
    shot.depth = args.depth.unwrap_or(shot.depth);
    let picture = take(&shot)?.picture;
    let name = shot.scene.name();
    let mut map = counted(&shot)?;
    if let Some(chip) = args.chip {
        map.charge(&accounted(chip, &shot)?);
    }
    let what = args.what.unwrap_or(if args.chip.is_some() { What::Instructions } else { What::Rays });
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{name}-cost.png")));
    png::write(&path, &heat(&map, what, &picture)).map_err(|error| Error::Write(path.clone(), error))?;
    writeln!(out, "{name}: {}", shot.scene.double.about)?;
    totals(out, &map)?;
    writeln!(out, "\n{}", bars(&map, what))?;
    writeln!(out, "{}", dearest(&map, what, &Names::of(&shot.scene), DEAREST))?;
    Ok(report::line(out, "file", path.display())?)
}

fn accounted(chip: &'static Chip, shot: &Shot) -> Result<Account, Error> {
    tell(&format!("building firmware with {} and running it on {}", shot.scene.name(), chip.name));
    Ok(account(chip, &shot.scene, shot.depth)?)
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
    report::line(out, "rows", format!("{beside:.0} operations each beside its pixels"))?;
    executed(out, map)
}

/// Prints what a chip has executed, if one was asked: rows as they are drawn, and pixels alone.
fn executed(out: &mut impl Write, map: &Map) -> Result<(), Error> {
    let sum = |bills: &[Bill]| bills.iter().filter_map(|bill| bill.instructions).sum::<u64>();
    let rows = map.rows.iter().enumerate().filter_map(|(y, bill)| Some((bill.instructions?, y)));
    let (Some((least, cheap)), Some((most, dear))) = (rows.clone().min(), rows.max()) else { return Ok(()) };
    let pixels = map.pixels.len() as f64;
    let [drawn, alone] = [&map.rows, &map.pixels].map(|bills| sum(bills) as f64 / pixels);
    report::line(out, "executed", format!("{drawn:.1} instructions a pixel in rows, {alone:.1} alone"))?;
    let range = format!("{least} instructions in row {cheap} to {most} in row {dear}");
    Ok(report::line(out, "a row", range)?)
}
