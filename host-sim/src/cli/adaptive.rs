use super::Error;
use super::args::CompareArgs;
use super::take::take;
use crate::scenes::Entry;
use crate::shot::{Number, Quality, Sampling, Shot, Taken};
use serde::Serialize;
use std::io::Write;

/// Is two steps of a 5-bit channel in 8 bits, rounded as panels are shown.
const TWO_STEPS: u8 = 17;

/// Answers the quality of which this one leaves out rays, if it does.
pub(super) fn whole(quality: Quality) -> Option<Quality> {
    match quality {
        Quality::Adaptive => Some(Quality::Exact),
        Quality::Sampled(sampling @ Sampling { at_edges: true, .. }) => {
            Some(Quality::Sampled(Sampling { at_edges: false, ..sampling }))
        }
        Quality::Exact | Quality::Sampled(_) => None,
    }
}

/// Says how far an adaptive picture is from the whole one, and how much less was traced.
#[derive(Debug, Serialize)]
struct Kept {
    scene: &'static str,
    number: &'static str,
    panel: &'static str,
    /// Share of pixels with a channel off by more than two steps of 5 bits.
    over_two_steps: f64,
    /// Largest difference of a channel, as a share of 1.
    worst: f64,
    /// Share of the whole picture's rays from the eye, and of all its rays, that were traced.
    traced: f64,
    rays: f64,
}

impl Kept {
    fn of(shot: &Shot, whole: &Taken, adaptive: &Taken) -> Self {
        let pairs = whole.picture.pixels.iter().zip(&adaptive.picture.pixels);
        let off: Vec<u8> =
            pairs.map(|(a, b)| (0..3).map(|i| a[i].abs_diff(b[i])).max().unwrap_or(0)).collect();
        let over = off.iter().filter(|off| **off > TWO_STEPS).count();
        let rays = |taken: &Taken| {
            let rays = taken.rays.unwrap_or_default();
            [rays.primary, rays.total()].map(|count| count as f64)
        };
        let ([all_primary, all], [primary, some]) = (rays(whole), rays(adaptive));
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

/// Compares adaptive pictures with whole ones of the same number.
pub(super) fn run(
    args: &CompareArgs,
    whole: Quality,
    entries: &[Entry],
    out: &mut impl Write,
) -> Result<(), Error> {
    let mut all = vec![];
    for entry in entries {
        for number in args.numbers() {
            all.push(compare(args, whole, *entry, number)?);
        }
    }
    if args.json {
        let text = serde_json::to_string_pretty(&all).map_err(std::io::Error::from)?;
        return Ok(writeln!(out, "{text}")?);
    }
    table(out, &all)
}

fn compare(args: &CompareArgs, whole: Quality, entry: Entry, number: Number) -> Result<Kept, Error> {
    let mut shot = Shot { number, panel: args.panel, ..Shot::new(entry) };
    shot.size = args.size.unwrap_or(shot.size);
    let whole = take(&Shot { quality: whole, ..shot })?;
    let adaptive = take(&Shot { quality: args.rays.quality(), ..shot })?;
    Ok(Kept::of(&shot, &whole, &adaptive))
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
        "\nEach adaptive picture against the whole one of the same number. Over 2/31 is the share of pixels with a\n\
         channel off by more than two steps of 5 bits; worst is a channel's, of 255; traced and rays are the\n\
         shares of the whole picture's rays from the eye and of all its rays that were traced."
    )?;
    Ok(())
}
