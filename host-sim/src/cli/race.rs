use super::Error;
use super::args::RaceArgs;
use crate::race::{Course, Lap, Rules};
use std::io::Write;

/// Races on every scene and prints a table, in the way Markdown has tables.
pub(super) fn run(args: &RaceArgs, out: &mut impl Write) -> Result<(), Error> {
    let rules = Rules { size: args.size, runs: args.runs };
    // All programs run before the first line is printed: a missing one leaves no half table.
    let laps = Course::all().iter().map(|course| course.race(rules)).collect::<Result<Vec<_>, _>>()?.concat();
    writeln!(
        out,
        "| scene | program | threads | seconds | Mpixel/s | times ours | PSNR dB | off by more than 8/255 |"
    )?;
    writeln!(out, "|---|---|--:|--:|--:|--:|--:|--:|")?;
    for lap in &laps {
        row(out, lap, args.size)?;
    }
    let ([columns, rows], runs) = (args.size, args.runs);
    writeln!(
        out,
        "\n{columns}x{rows} pixels, one ray each, best of {runs}. Seconds are those of tracing alone, as each program\n\
         counts them. The pictures, at the scenes' usual size, are compared with the f64 reference: PSNR away\n\
         from silhouettes (99 dB: equal), pixels off by more than 8/255 in the whole picture."
    )?;
    Ok(())
}

fn row(out: &mut impl Write, lap: &Lap, [columns, rows]: [u32; 2]) -> Result<(), Error> {
    let Lap { scene, program, threads, time, ratio, figures } = lap;
    // A clock may be too coarse for a tiny picture.
    let seconds = time.as_secs_f64().max(1e-9);
    let pace = f64::from(columns) * f64::from(rows) / seconds / 1e6;
    let (psnr, over) = (figures.psnr_db, 100.0 * figures.over_8);
    writeln!(
        out,
        "| {scene} | {program} | {threads} | {seconds:.3} | {pace:.2} | {ratio:.2} | {psnr:.1} | {over:.2} % |"
    )?;
    Ok(())
}
