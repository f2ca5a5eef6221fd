use super::args::ProgressiveArgs;
use super::{Error, report};
use crate::animation::Animation;
use crate::refine::Step;
use crate::shot::{Picture, Shot};
use scanray::trace::RayCounts;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::ops::Range;
use std::path::PathBuf;

/// Is the share of all rays after which a frame is shown.
const FRAMES: u64 = 32;

/// Is how long a frame is shown, in hundredths of a second.
const FRAME: u16 = 12;

/// Is how long the finished picture is shown.
const END: u16 = 250;

/// Draws a scene in blocks that become finer, writes it to a file and tells what each pass took.
pub(super) fn run(args: &ProgressiveArgs, out: &mut impl Write) -> Result<(), Error> {
    let shot = args.look.shot()?;
    let (passes, frames) = record(&shot, args.block)?;
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}.gif", shot.scene.name())));
    write(&path, shot.size, &frames).map_err(|error| Error::Write(path.clone(), error))?;
    writeln!(out, "{}: {}", shot.scene.name(), shot.scene.double.about)?;
    let all = passes.last().map_or(1, |(_, rays)| rays.total()).max(1);
    for (side, rays) in &passes {
        let share = 100.0 * rays.total() as f64 / all as f64;
        report::line(
            out,
            &format!("blocks {side}"),
            format!("{share:.1}% of all rays, all passes before counted"),
        )?;
    }
    report::line(out, "file", path.display())?;
    Ok(())
}

/// Is rows of a picture, to be shown over what is shown already.
struct Frame {
    picture: Picture,
    rows: Range<u32>,
}

/// Is the side of a pass's blocks, with all rays up to its end.
type Pass = (u8, RayCounts);

/// Draws the picture and answers its passes and what there is to show.
fn record(shot: &Shot, block: u8) -> Result<(Vec<Pass>, Vec<Frame>), Error> {
    let mut all = RayCounts::default();
    let refused = |refusal| Error::refused(&shot.scene, refusal);
    shot.refine(block, |step| all = step.rays).map_err(refused)?;
    let (mut passes, mut frames) = (Vec::<Pass>::new(), Vec::new());
    let interval = all.total().div_ceil(FRAMES);
    let mut shown = Reel { rows: 0..0, next: interval, interval };
    shot.refine(block, |step| {
        frames.extend(shown.add(&step));
        match passes.last_mut() {
            Some((side, rays)) if *side == step.side => *rays = step.rays,
            _ => passes.push((step.side, step.rays)),
        }
    })
    .map_err(refused)?;
    Ok((passes, frames))
}

/// Gathers steps to frames.
struct Reel {
    /// The rows drawn in since the last frame.
    rows: Range<u32>,
    /// The count of rays at which the next frame is due.
    next: u64,
    interval: u64,
}

impl Reel {
    /// Answers a frame when one is due, and at the end of each pass.
    fn add(&mut self, step: &Step<'_>) -> Option<Frame> {
        let Range { start, end } = step.rows;
        self.rows = if self.rows.is_empty() {
            start..end
        } else {
            self.rows.start.min(start)..self.rows.end.max(end)
        };
        let ends_pass = end == step.picture.size[1];
        (ends_pass || step.rays.total() >= self.next).then(|| {
            self.next = step.rays.total() + self.interval;
            Frame { picture: step.picture.clone(), rows: std::mem::take(&mut self.rows) }
        })
    }
}

fn write(path: &PathBuf, size: [u32; 2], frames: &[Frame]) -> io::Result<()> {
    let mut file = BufWriter::new(File::create(path)?);
    let mut animation = Animation::new(&mut file, size)?;
    for (i, Frame { picture, rows }) in frames.iter().enumerate() {
        let hundredths = if i + 1 == frames.len() { END } else { FRAME };
        animation.show(picture, rows.clone(), hundredths)?;
    }
    drop(animation);
    file.flush()
}
