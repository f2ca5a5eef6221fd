use super::args::ApproachesArgs;
use super::look::scene;
use super::take::take;
use super::{Error, report};
use crate::bench::{Row, Snapshot};
use crate::png;
use crate::shot::{Approach, Picture, Shot, Taken};
use embedded_graphics::mono_font::ascii::FONT_6X10;
use std::io::Write;
use std::path::PathBuf;

/// Draws a scene by the tracer and by the z-buffer, side by side, and tells what each has done for it.
pub(super) fn run(args: &ApproachesArgs, out: &mut impl Write) -> Result<(), Error> {
    let mut shot = Shot::new(scene(&args.scene)?);
    (shot.number, shot.panel) = (args.number, args.panel);
    shot.size = args.size.unwrap_or(shot.size);
    let by = |approach| take(&Shot { approach, ..shot });
    let (traced, rasterized) = (by(Approach::Trace)?, by(Approach::Raster)?);
    let name = shot.scene.name();
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{name}-approaches.png")));
    let page = side_by_side(&traced.picture, &rasterized.picture);
    png::write(&path, &page).map_err(|error| Error::Write(path.clone(), error))?;
    writeln!(out, "{name}: {}", shot.scene.double.about)?;
    report::line(out, "tracer", traced_work(&traced))?;
    report::line(out, "z-buffer", rasterized_work(&rasterized))?;
    for line in instructions(&shot) {
        report::line(out, "device", line)?;
    }
    Ok(report::line(out, "file", path.display())?)
}

fn traced_work(taken: &Taken) -> String {
    let rays = taken.rays.unwrap_or_default();
    let [primary, shadow, reflection] = [rays.primary, rays.shadow, rays.reflection].map(report::thousands);
    let time = report::milliseconds(taken.time);
    format!("{primary} rays from the eye, {shadow} to lights, {reflection} from mirrors; {time}")
}

fn rasterized_work(taken: &Taken) -> String {
    let tested = taken.fragments.unwrap_or_default();
    let pixels = taken.picture.pixels.len().max(1);
    let time = report::milliseconds(taken.time);
    let layers = tested as f64 / pixels as f64;
    format!("{} depths tested, {layers:.2} a pixel; no ray at all; {time}", report::thousands(tested))
}

/// Answers what both take on the chips they have been measured on, by the figures kept with the sources.
fn instructions(shot: &Shot) -> Vec<String> {
    let kept = Snapshot::read().unwrap_or_default().0;
    let of = |mode: &'static str| {
        kept.iter().filter(move |row| row.scene == shot.scene.name() && row.mode == mode)
    };
    let pairs =
        of("exact").filter_map(|exact| Some((exact, of("raster").find(|row| row.chip == exact.chip)?)));
    let say = |(exact, raster): (&Row, &Row)| {
        format!(
            "{}: {:.0} instructions a pixel traced, {:.0} rasterised",
            exact.chip, exact.instr_per_px, raster.instr_per_px
        )
    };
    pairs.map(say).collect()
}

/// Answers both pictures, the traced one to the left, with their names above.
fn side_by_side(traced: &Picture, rasterized: &Picture) -> Picture {
    const GAP: u32 = 4;
    const LABEL: u32 = 14;
    let [width, height] = traced.size;
    let mut page = Picture::filled([2 * width + 3 * GAP, height + LABEL + GAP], [32; 3]);
    for (column, picture, label) in [(0, traced, "ray tracer"), (1, rasterized, "z-buffer")] {
        let left = GAP + column * (width + GAP);
        page.paste(picture, [left, LABEL]);
        page.write_text(label, [left, 2], &FONT_6X10);
    }
    page
}
