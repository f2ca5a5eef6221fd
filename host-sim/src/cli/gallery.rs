use super::look::{scene, size};
use super::progress::Progress;
use super::{Error, report};
use crate::bench::Snapshot;
use crate::exhibition::{Exhibition, Room, Unhung};
use crate::scenes::{self, Entry};
use crate::shot::{Refusal, Shot};
use clap::Args;
use std::io::Write;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray gallery -o public\n  \
    scanray gallery glass mine.ron -o public --size 160x120\n\n\
    The folder goes on any web server; `index.html` in it can be opened as it is, too.")]
pub(super) struct GalleryArgs {
    /// Scenes to show: of the gallery, or files FILE.ron, FILE.nff or FILE.obj [default: the gallery]
    #[arg(value_name = "SCENE")]
    pub scenes: Vec<String>,
    /// Folder to write the pages to
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Columns and rows of every picture, such as 160x120 [default: each scene's]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<[u32; 2]>,
}

/// Puts up an exhibition of scenes.
pub(super) fn run(args: &GalleryArgs, out: &mut impl Write) -> Result<(), Error> {
    let entries: Vec<Entry> = if args.scenes.is_empty() {
        scenes::all().collect()
    } else {
        args.scenes.iter().map(|name| scene(name)).collect::<Result<_, _>>()?
    };
    let failed = |error| Error::Write(args.output.clone(), error);
    let mut exhibition = Exhibition::new(&args.output, Snapshot::read()?).map_err(failed)?;
    let mut progress = Progress::new(entries.len() as u64, "hanging pictures".into());
    for entry in entries {
        let mut shot = Shot::new(entry);
        shot.size = args.size.unwrap_or(shot.size);
        exhibition.open(&room(shot)?).map_err(failed)?;
        progress.step();
    }
    drop(progress);
    let entrance = exhibition.close().map_err(failed)?;
    Ok(report::line(out, "file", entrance.display())?)
}

fn room(shot: Shot) -> Result<Room, Error> {
    Room::hang(shot).map_err(|unhung| match unhung {
        Unhung::Picture(refusal) => Error::refused(&shot.scene, refusal),
        Unhung::Cost(crate::cost::Uncounted::Core(error)) => {
            Error::refused(&shot.scene, Refusal::Core(error))
        }
        Unhung::Cost(crate::cost::Uncounted::Scene(unsayable)) => Error::Uncounted(unsayable),
    })
}
