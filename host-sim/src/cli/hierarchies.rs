use super::hierarchies_args::HierarchiesArgs;
use super::progress::Progress;
use super::{Error, report};
use crate::bake::Accel;
use crate::bench::{self, Chip, Cost};
use crate::growth::{Crowd, Sample, measure, plot};
use crate::png;
use std::io::Write;

/// Measures every kind of hierarchy, over crowds of every size or on a chip.
pub(super) fn run(args: &HierarchiesArgs, out: &mut impl Write) -> Result<(), Error> {
    let kinds = args.kind.map_or(Accel::ALL.to_vec(), |kind| vec![kind]);
    match args.chip {
        Some(chip) => run_on(chip, &kinds, out),
        None => run_here(args, &kinds, out),
    }
}

/// Counts what the teapot costs on a chip with each kind and prints a table.
fn run_on(chip: &Chip, kinds: &[Accel], out: &mut impl Write) -> Result<(), Error> {
    let mut progress = Progress::new(kinds.len() as u64, format!("measuring on {}", chip.name));
    let mut costs = vec![];
    for kind in kinds {
        costs.push(bench::cost(chip, *kind)?);
        progress.step();
    }
    drop(progress);
    writeln!(
        out,
        "| {} | bytes a triangle | flash | instr/px | rows counted | build ms |\n|---|--:|--:|--:|--:|--:|",
        chip.name
    )?;
    for Cost { accel, bytes_each, instr_per_px, flash, rows, build } in costs {
        let (kind, build) = (accel.name(), build.as_secs_f64() * 1e3);
        writeln!(
            out,
            "| {kind} | {bytes_each:.1} | {flash} | {instr_per_px:.1} | {rows} of {} | {build:.1} |",
            bench::SIZE[1]
        )?;
    }
    Ok(writeln!(
        out,
        "\nThe teapot's 992 triangles in {}, 320x240. Instructions are all that the picture takes, flash is the\n\
         whole image; each kind draws the very picture of the host. Times are those of this computer.",
        chip.number.name()
    )?)
}

/// Measures kinds over crowds of every size, prints a table and draws a diagram.
fn run_here(args: &HierarchiesArgs, kinds: &[Accel], out: &mut impl Write) -> Result<(), Error> {
    let crowds: Vec<_> = Crowd::ALL
        .into_iter()
        .flat_map(|crowd| crowd.sizes().into_iter().map(move |things| (crowd, things)))
        .filter(|(_, things)| things.len() <= args.most)
        .collect();
    let mut progress = Progress::new((crowds.len() * kinds.len()) as u64, "building and walking".into());
    let mut samples = vec![];
    for (crowd, things) in &crowds {
        for kind in kinds {
            samples.push(measure(*crowd, things, *kind));
            progress.step();
        }
    }
    drop(progress);
    if let Some(path) = &args.output {
        png::write(path, &plot(&samples)).map_err(|error| Error::Write(path.clone(), error))?;
    }
    for crowd in Crowd::ALL {
        table(out, crowd, samples.iter().filter(|sample| sample.crowd == crowd))?;
    }
    writeln!(
        out,
        "Means over rays from all around, each of which looks for the nearest thing. Operations are sums,\n\
         products, quotients and roots of the number, those of the things asked included; those in whole numbers,\n\
         by which the tree of boxes asks its boxes, are not. Times are those of f32 on this computer."
    )?;
    if let Some(path) = &args.output {
        report::line(out, "file", path.display())?;
    }
    Ok(())
}

/// Prints what was measured of one crowd, in the way Markdown has tables.
fn table<'s>(
    out: &mut impl Write,
    crowd: Crowd,
    samples: impl Iterator<Item = &'s Sample>,
) -> Result<(), Error> {
    writeln!(
        out,
        "| {} | kind | bytes each | build ms | asked a ray | operations a ray | ns a ray |\n\
         |--:|---|--:|--:|--:|--:|--:|",
        crowd.name()
    )?;
    for Sample { accel, things, bytes, build, asked, operations, time, .. } in samples {
        let (each, build) = (*bytes as f64 / *things as f64, build.as_secs_f64() * 1e3);
        let (kind, time) = (accel.name(), time.as_nanos());
        writeln!(
            out,
            "| {things} | {kind} | {each:.1} | {build:.1} | {asked:.1} | {operations:.0} | {time} |"
        )?;
    }
    Ok(writeln!(out)?)
}
