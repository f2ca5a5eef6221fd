use super::args::{RenderArgs, ShowArgs};
use super::progress::Progress;
use super::take::take;
use super::{Error, report};
use crate::compare::Comparison;
use crate::picture;
use crate::png;
use crate::shot::{Number, Picture, Shot, Taken};
use crate::show;
use crate::terminal::{self, Style};
use std::io::{IsTerminal, Write};
use std::path::PathBuf;

/// Draws a scene, writes it to a file, tells what it took and shows it.
pub(super) fn run(args: &RenderArgs, out: &mut impl Write) -> Result<(), Error> {
    let shot = args.look.shot()?;
    let taken = picture::pool(args.threads)?.install(|| take(&shot))?;
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}.png", shot.scene.name())));
    png::write(&path, &taken.picture).map_err(|error| Error::Write(path.clone(), error))?;
    let windowed = !args.no_window && is_attended() && show::has_display();
    if !windowed {
        preview(out, &taken.picture)?;
    }
    report::taken(out, &shot, &taken)?;
    difference(out, &shot, &taken)?;
    report::line(out, "file", path.display())?;
    if windowed {
        report::line(out, "window", "Esc closes it, H names its keys")?;
        out.flush()?;
        match show::run(shot, false, None) {
            Ok(saved) => say_saved(out, &saved)?,
            // The picture is made and written; that the display refuses a window changes nothing.
            Err(refusal) => {
                report::line(out, "no window", refusal)?;
                preview(out, &taken.picture)?;
            }
        }
    }
    Ok(())
}

/// Opens the window in which one walks around a scene.
pub(super) fn show(args: &ShowArgs, out: &mut impl Write) -> Result<(), Error> {
    let shot = args.look.shot()?;
    if !show::has_display() {
        return Err(Error::NoDisplay);
    }
    say_saved(out, &show::run(shot, args.spin, args.frames)?)
}

fn say_saved(out: &mut impl Write, saved: &[PathBuf]) -> Result<(), Error> {
    for path in saved {
        report::line(out, "saved", path.display())?;
    }
    Ok(())
}

/// Prints how far the picture is from the reference.
fn difference(out: &mut impl Write, shot: &Shot, taken: &Taken) -> Result<(), Error> {
    if shot.number == Number::Oracle {
        return Ok(report::line(out, "difference", "none, this is the reference")?);
    }
    let figures = shot.judge(&taken.picture, &reference(shot)?);
    Ok(report::difference(out, &figures)?)
}

/// Traces the reference picture, with a progress bar if it takes long.
pub(super) fn reference(shot: &Shot) -> Result<Comparison, Error> {
    let what = format!("drawing the reference of {}", shot.scene.name());
    let mut progress = Progress::new(u64::from(shot.size[1]), what);
    shot.reference(|_| progress.step()).map_err(|refusal| Error::refused(&shot.scene, refusal))
}

/// Answers whether someone sits at the terminal: a window nobody can close must not open.
fn is_attended() -> bool {
    std::io::stdin().is_terminal() && std::io::stdout().is_terminal()
}

/// Is what the report, the prompt and the command line take of the terminal's lines.
const REPORT_LINES: u32 = 12;

/// Draws the picture in the terminal, if stdout is one.
fn preview(out: &mut impl Write, picture: &Picture) -> Result<(), Error> {
    if !std::io::stdout().is_terminal() {
        return Ok(());
    }
    let (columns, lines) = terminal_size::terminal_size().map_or((80, 40), |(w, h)| (w.0, h.0));
    let lines = u32::from(lines).saturating_sub(REPORT_LINES).max(8);
    Ok(out.write_all(terminal::preview(picture, u32::from(columns), lines, style()).as_bytes())?)
}

/// Answers what the terminal can show, by the usual variables.
fn style() -> Style {
    let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let is_dumb = std::env::var_os("TERM").is_some_and(|value| value == "dumb");
    if is_set("NO_COLOR") || is_dumb { Style::Letters } else { Style::Color }
}
