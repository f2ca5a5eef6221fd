use super::Error;
use super::args::CompareArgs;
use super::render::take;
use crate::scenes::Entry;
use crate::shot::{Number, Quality, Shot, Taken};
use serde::Serialize;
use std::io::Write;

/// Is two steps of a 5-bit channel in 8 bits, rounded as panels are shown.
const TWO_STEPS: u8 = 17;

/// Says how far an adaptive picture is from the exact one, and how much less was traced.
#[derive(Debug, Serialize)]
struct Kept {
    scene: &'static str,
    number: &'static str,
    panel: &'static str,
    /// Share of pixels with a channel off by more than two steps of 5 bits.
    over_two_steps: f64,
    /// Largest difference of a channel, as a share of 1.
    worst: f64,
    /// Share of the exact picture's rays from the eye, and of all its rays, that were traced.
    traced: f64,
    rays: f64,
}

impl Kept {
    fn of(shot: &Shot, exact: &Taken, adaptive: &Taken) -> Self {
        let pairs = exact.picture.pixels.iter().zip(&adaptive.picture.pixels);
        let off: Vec<u8> =
            pairs.map(|(a, b)| (0..3).map(|i| a[i].abs_diff(b[i])).max().unwrap_or(0)).collect();
        let over = off.iter().filter(|off| **off > TWO_STEPS).count();
        let rays = |taken: &Taken| {
            let rays = taken.rays.unwrap_or_default();
            [rays.primary, rays.total()].map(|count| count as f64)
        };
        let ([all_primary, all], [primary, some]) = (rays(exact), rays(adaptive));
        Self {
            scene: shot.scene.name(),
            number: shot.number.name(),
            panel: shot.panel.name(),
            over_two_steps: over as f64 / off.len() as f64,
            worst: f64::from(off.into_iter().max().unwrap_or(0)) / 255.0,
            traced: primary / all_primary,
            rays: some / all,
        }
    }
}

/// Compares adaptive pictures with exact ones of the same number.
pub(super) fn run(args: &CompareArgs, entries: &[Entry], out: &mut impl Write) -> Result<(), Error> {
    let mut all = vec![];
    for entry in entries {
        for number in args.numbers() {
            all.push(compare(args, *entry, number)?);
        }
    }
    if args.json {
        let text = serde_json::to_string_pretty(&all).map_err(std::io::Error::from)?;
        return Ok(writeln!(out, "{text}")?);
    }
    table(out, &all)
}

fn compare(args: &CompareArgs, entry: Entry, number: Number) -> Result<Kept, Error> {
    let mut shot = Shot { number, panel: args.panel, ..Shot::new(entry) };
    shot.size = args.size.unwrap_or(shot.size);
    let exact = take(&Shot { quality: Quality::Exact, ..shot })?;
    let adaptive = take(&Shot { quality: Quality::Adaptive, ..shot })?;
    Ok(Kept::of(&shot, &exact, &adaptive))
}

/// Prints figures as a table, and what its columns mean.
fn table(out: &mut impl Write, all: &[Kept]) -> Result<(), Error> {
    let width = all.iter().map(|kept| kept.scene.len()).max().unwrap_or(0).max("scene".len());
    let head = ["number", "panel", "over 2/31", "worst", "traced", "rays"];
    let [number, panel, over, worst, traced, rays] = head;
    writeln!(
        out,
        "{:width$}  {number:6}  {panel:6}  {over:>9}  {worst:>7}  {traced:>7}  {rays:>7}",
        "scene"
    )?;
    for Kept { scene, number, panel, over_two_steps, worst, traced, rays } in all {
        let over = format!("{:.3}%", 100.0 * over_two_steps);
        let worst = format!("{:.0}/255", 255.0 * worst);
        let [traced, rays] = [traced, rays].map(|share| format!("{:.1}%", 100.0 * share));
        writeln!(
            out,
            "{scene:width$}  {number:6}  {panel:6}  {over:>9}  {worst:>7}  {traced:>7}  {rays:>7}"
        )?;
    }
    writeln!(
        out,
        "\nEach adaptive picture against the exact one of the same number. Over 2/31 is the share of pixels with a\n\
         channel off by more than two steps of 5 bits; worst is a channel's, of 255; traced and rays are the\n\
         shares of the exact picture's pixels and of all its rays that were traced."
    )?;
    Ok(())
}
