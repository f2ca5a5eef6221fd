use super::hierarchies_args::HierarchiesArgs;
use super::progress::Progress;
use super::{Error, report};
use crate::bake::Accel;
use crate::growth::{Crowd, Sample, measure, plot};
use crate::png;
use std::io::Write;

/// Measures every kind of hierarchy over crowds of every size, prints a table and draws a diagram.
pub(super) fn run(args: &HierarchiesArgs, out: &mut impl Write) -> Result<(), Error> {
    let crowds: Vec<_> = Crowd::ALL
        .into_iter()
        .flat_map(|crowd| crowd.sizes().into_iter().map(move |things| (crowd, things)))
        .filter(|(_, things)| things.len() <= args.most)
        .collect();
    let kinds = args.kind.map_or(Accel::ALL.to_vec(), |kind| vec![kind]);
    let mut progress = Progress::new((crowds.len() * kinds.len()) as u64, "building and walking".into());
    let mut samples = vec![];
    for (crowd, things) in &crowds {
        for kind in &kinds {
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
         products, quotients and roots, those of the things asked included; times are those of f32 on this\n\
         computer."
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
