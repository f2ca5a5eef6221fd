use super::args::DitherArgs;
use super::look::{Curve, scene};
use super::progress::Progress;
use super::{Error, report};
use crate::dither::{Method, Window, error};
use crate::panel::Panel;
use crate::picture::{self, Film};
use crate::png;
use crate::shot::Picture;
use embedded_graphics::mono_font::ascii::FONT_6X10;
use scanray::{Fixed, Transfer};
use std::io::Write;
use std::path::PathBuf;

/// Lists the panels that need dithering most, and the one in most devices.
const PANELS: [Panel; 3] = [Panel::Mono, Panel::Gray4, Panel::Rgb565];

/// Is a picture rounded in some way, and how far its local means are off, in steps of 8 bits.
struct Rounded {
    panel: Panel,
    method: Method,
    picture: Picture,
    errors: [f64; 2],
}

/// Draws a scene for three panels by each way of rounding, on one sheet, and prints what each is worth.
pub(super) fn run(args: &DitherArgs, out: &mut impl Write) -> Result<(), Error> {
    let entry = scene(&args.scene)?;
    let view = entry.fixed;
    let size = args.size.unwrap_or(view.size);
    let transfer = args.transfer.map_or(view.settings.transfer, Curve::transfer);
    let mut progress = Progress::new(u64::from(size[1]), format!("drawing {}", view.name));
    let film = picture::trace(view, view.settings, size, |_| progress.step())
        .map_err(|error| Error::refused(&entry, error.into()))?;
    let all: Vec<Rounded> = PANELS.iter().flat_map(|panel| every_way(&film, *panel, transfer)).collect();
    table(out, &all)?;
    let default = || PathBuf::from(format!("{}-dither.png", view.name));
    let path = args.output.clone().unwrap_or_else(default);
    png::write(&path, &sheet(&all, size)).map_err(|error| Error::Write(path.clone(), error))?;
    Ok(report::line(out, "file", path.display())?)
}

/// Rounds a picture for a panel in every way.
fn every_way(film: &Film<Fixed>, panel: Panel, transfer: Transfer) -> [Rounded; 4] {
    let levels = film.levels(panel, transfer);
    let seen = |[first, second, third]: [u32; 3]| {
        let channels = if panel.is_gray() { [first; 3] } else { [first, second, third] };
        channels.map(|level| f64::from(level) * 255.0 / 65_536.0)
    };
    let wanted: Vec<[f64; 3]> = levels.iter().copied().map(seen).collect();
    Method::ALL.map(|method| {
        let pixels = panel.round(&levels, film.size[0], method.dither());
        let shown: Vec<[f64; 3]> = pixels.iter().map(|pixel| panel.exactly(*pixel)).collect();
        let off = |window| error(&shown, &wanted, film.size[0] as usize, window);
        let errors = [Window::Box, Window::Gaussian].map(off);
        Rounded { panel, method, picture: Picture { size: film.size, pixels }, errors }
    })
}

/// Answers all pictures, a panel to a row and a method to a column.
fn sheet(all: &[Rounded], [width, height]: [u32; 2]) -> Picture {
    const GAP: u32 = 4;
    const LABEL: u32 = 14;
    let columns = Method::ALL.len() as u32;
    let rows = PANELS.len() as u32;
    let mut page = Picture::filled([columns * (width + GAP) + GAP, rows * (height + LABEL) + GAP], [32; 3]);
    for (place, rounded) in (0..).zip(all) {
        let corner = [GAP + place % columns * (width + GAP), place / columns * (height + LABEL)];
        page.paste(&rounded.picture, [corner[0], corner[1] + LABEL]);
        let room = (width / FONT_6X10.character_size.width) as usize;
        let label = format!("{} {}", rounded.panel.name(), rounded.method.name());
        let label: String = label.chars().take(room).collect();
        page.write_text(&label, [corner[0], corner[1] + 2], &FONT_6X10);
    }
    page
}

/// Prints the errors as a table, and what its columns mean.
fn table(out: &mut impl Write, all: &[Rounded]) -> Result<(), Error> {
    writeln!(out, "{:6}  {:10}  {:>7}  {:>8}", "panel", "method", "box 8x8", "gaussian")?;
    for Rounded { panel, method, errors: [square, gaussian], .. } in all {
        writeln!(out, "{:6}  {:10}  {square:>7.2}  {gaussian:>8.2}", panel.name(), method.name())?;
    }
    writeln!(
        out,
        "\nHow far local means of what is shown are from what was to be shown: the root of the mean square, in\n\
         levels of 255, of means over squares of 8x8 pixels and by a Gaussian of 1.5 pixels. Levels, because\n\
         rounding keeps their mean; on a panel whose light follows its levels, take --transfer linear.\n"
    )?;
    Ok(())
}
