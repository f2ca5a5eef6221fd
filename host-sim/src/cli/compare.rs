use super::adaptive;
use super::args::CompareArgs;
use super::look::scene;
use super::render::reference;
use super::take::take;
use super::{Error, report};
use crate::compare::{Comparison, Figures, difference};
use crate::png;
use crate::scenes::{self, Entry};
use crate::shot::{Number, Picture, Shot};
use embedded_graphics::mono_font::ascii::FONT_6X10;
use std::io::Write;
use std::path::PathBuf;

/// Judges scenes by the reference; prints figures and writes pictures.
pub(super) fn run(args: &CompareArgs, out: &mut impl Write) -> Result<(), Error> {
    let entries: Vec<Entry> = match &args.scene {
        Some(name) => vec![scene(name)?],
        None if args.all => scenes::all().collect(),
        None => return Err(Error::NothingToCompare),
    };
    if let Some(whole) = adaptive::whole(args.rays.quality()) {
        return adaptive::run(args, whole, &entries, out);
    }
    let directory = directory(args)?;
    let mut all = vec![];
    let mut files = vec![];
    for entry in entries {
        let compared = Compared::make(args, entry)?;
        if let Some(directory) = &directory {
            let path = directory.join(format!("{}-compare.png", entry.name()));
            png::write(&path, &compared.side_by_side()).map_err(|e| Error::Write(path.clone(), e))?;
            files.push(path);
        }
        all.extend(compared.judged.into_iter().map(|judged| judged.figures));
    }
    if args.json {
        let text = serde_json::to_string_pretty(&all).map_err(std::io::Error::from)?;
        return Ok(writeln!(out, "{text}")?);
    }
    table(out, &all)?;
    for path in files {
        report::line(out, "file", path.display())?;
    }
    Ok(())
}

/// Answers where pictures go, if any are to be written; makes the directory.
fn directory(args: &CompareArgs) -> Result<Option<PathBuf>, Error> {
    let Some(path) = &args.output else {
        return Ok((args.scene.is_some() && !args.json).then(PathBuf::new));
    };
    std::fs::create_dir_all(path).map_err(|error| Error::Write(path.clone(), error))?;
    Ok(Some(path.clone()))
}

/// Is a scene in several numbers, with what is to be said of each.
struct Compared {
    judged: Vec<Judged>,
    reference: Picture,
}

struct Judged {
    number: Number,
    picture: Picture,
    difference: Picture,
    figures: Figures,
}

impl Compared {
    fn make(args: &CompareArgs, entry: Entry) -> Result<Self, Error> {
        let mut shot = Shot::new(entry);
        shot.panel = args.panel;
        shot.quality = args.rays.quality();
        shot.size = args.size.unwrap_or(shot.size);
        let truth = reference(&shot)?;
        let shown = Picture { size: shot.size, pixels: truth.on_panel(shot.panel) };
        let asked = args.numbers();
        let judged =
            asked.map(|number| judge(&Shot { number, ..shot }, &truth, &shown)).collect::<Result<_, _>>()?;
        Ok(Self { judged, reference: shown })
    }

    /// Answers all pictures in a row, the reference last, each over its difference.
    fn side_by_side(&self) -> Picture {
        const GAP: u32 = 4;
        const LABEL: u32 = 14;
        let [width, height] = self.reference.size;
        let count = self.judged.len() as u32 + 1;
        let whole = [count * (width + GAP) + GAP, 2 * (height + LABEL) + GAP];
        let mut page = Picture::filled(whole, [32; 3]);
        let mut put = |picture: &Picture, label: &str, [column, row]: [u32; 2]| {
            let [left, top] = [GAP + column * (width + GAP), row * (height + LABEL)];
            page.paste(picture, [left, top + LABEL]);
            let room = (width / FONT_6X10.character_size.width) as usize;
            let label: String = label.chars().take(room).collect();
            page.write_text(&label, [left, top + 2], &FONT_6X10);
        };
        for (column, judged) in (0..).zip(&self.judged) {
            let name = judged.number.name();
            put(&judged.picture, &format!("{name}  {:.1} dB", judged.figures.psnr_db), [column, 0]);
            put(&judged.difference, &format!("{name} - oracle, x 16"), [column, 1]);
        }
        put(&self.reference, "oracle", [count - 1, 0]);
        page
    }
}

fn judge(shot: &Shot, truth: &Comparison, shown: &Picture) -> Result<Judged, Error> {
    let picture = take(shot)?.picture;
    let pixels = difference(&picture.pixels, &shown.pixels, &truth.mask);
    let figures = shot.judge(&picture, truth);
    let difference = Picture { size: shot.size, pixels };
    Ok(Judged { number: shot.number, picture, difference, figures })
}

/// Prints figures as a table, and what its columns mean.
fn table(out: &mut impl Write, all: &[Figures]) -> Result<(), Error> {
    let width = all.iter().map(|figures| figures.scene.len()).max().unwrap_or(0).max("scene".len());
    let head = ["number", "panel", "PSNR dB", "whole dB", "worst", "over 1", "over 8", "silhouette"];
    let [number, panel, psnr, whole, worst, over_1, over_8, silhouette] = head;
    writeln!(
        out,
        "{:width$}  {number:6}  {panel:6}  {psnr:>7}  {whole:>8}  {worst:>7}  {over_1:>7}  {over_8:>7}  {silhouette:>10}",
        "scene"
    )?;
    for figures in all {
        row(out, figures, width)?;
    }
    writeln!(
        out,
        "\nEach number against the oracle, an independent f64 reference. PSNR is taken away from silhouettes\n\
         and of the whole picture (99 dB: equal); worst is a channel's, of 255; over 1 and over 8 are the\n\
         shares of pixels off by more than that of 255; silhouette is the share of pixels beside an edge."
    )?;
    Ok(())
}

fn row(out: &mut impl Write, figures: &Figures, width: usize) -> Result<(), Error> {
    let Figures { scene, number, panel, psnr_db, psnr_all_db, .. } = figures;
    let [over_1, over_8, silhouette] =
        [figures.over_1, figures.over_8, figures.silhouette].map(|share| format!("{:.2}%", 100.0 * share));
    let worst = format!("{:.0}/255", 255.0 * figures.worst);
    writeln!(
        out,
        "{scene:width$}  {number:6}  {panel:6}  {psnr_db:>7.2}  {psnr_all_db:>8.2}  {worst:>7}  {over_1:>7}  {over_8:>7}  {silhouette:>10}"
    )?;
    Ok(())
}
