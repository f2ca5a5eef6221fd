use crate::bake::file as bake;
use crate::bench::Failure;
use crate::boards;
use crate::lessons::{self, Language};
use crate::obj;
use crate::race;
use crate::scene_file::{self, Unsayable};
use crate::scenes::{self, Entry};
use crate::serve;
use crate::shot::Refusal;
use rayon::ThreadPoolBuildError;
use std::path::PathBuf;
use std::{fmt, io};

/// Tells what went wrong, and what to do about it.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// The gallery has no such scene.
    UnknownScene(String),
    /// The course has no such chapter.
    UnknownChapter(String, Language),
    /// A command of a chapter failed, and has told why.
    Chapter(String),
    /// A scene file cannot be read, or not be drawn.
    SceneFile(scene_file::Failure),
    /// A model cannot be read.
    Model(obj::Mistake),
    /// A scene cannot be written as source.
    Bake(bake::Failure),
    /// A scene cannot be written as a file.
    Export(Unsayable),
    /// A scene cannot be counted.
    Uncounted(Unsayable),
    /// A scene with images, meshes or voxels is to be written where no files can stand beside it.
    FilesToTerminal,
    /// The text of a scene file cannot be made.
    Text(ron::Error),
    /// A comparison names neither a scene nor all of them.
    NothingToCompare,
    /// The picture has no such pixel.
    NoSuchPixel {
        /// Column and row that were asked for.
        pixel: [u32; 2],
        /// Columns and rows that there are.
        size: [u32; 2],
    },
    /// The picture cannot be drawn.
    Render(Refusal),
    /// Something cannot be measured.
    Bench(Failure),
    /// The system starts no threads, or not so many.
    Threads(ThreadPoolBuildError),
    /// A race cannot be run.
    Race(race::Fault),
    /// The playground cannot be served.
    Serve(serve::Fault),
    /// No project can be begun.
    New(boards::Refusal),
    /// A file or a directory cannot be written.
    Write(PathBuf, io::Error),
    /// A window was asked for, and there is no display.
    NoDisplay,
    /// The display refuses the window.
    Window(String),
    /// The results cannot be printed.
    Output(io::Error),
}

impl Error {
    /// Makes the error of a picture that cannot be drawn: it shows the line of the scene's file, if there is
    /// one.
    pub(super) fn refused(scene: &Entry, refusal: Refusal) -> Self {
        match (scene.file, refusal) {
            (Some(file), Refusal::Core(error)) => {
                Self::SceneFile(scene_file::Failure::Wrong(Box::new(file.explain(error))))
            }
            _ => Self::Render(refusal),
        }
    }

    /// Answers whether it only means that nobody reads on, as when a pager is left.
    pub fn is_closed_pipe(&self) -> bool {
        matches!(self, Self::Output(error) if error.kind() == io::ErrorKind::BrokenPipe)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownScene(name) => {
                write!(f, "there is no scene '{name}'")?;
                if let Some(nearest) = scenes::nearest(name) {
                    write!(f, "; did you mean '{nearest}'?")?;
                }
                f.write_str(
                    "\n`scanray list` names them all; the name of a file ends in `.ron`, `.nff` or `.obj`.",
                )
            }
            Self::UnknownChapter(number, language) => {
                let chapters = lessons::contents(*language);
                write!(f, "there is no chapter '{number}'; `all` runs these:\n{}", chapters.trim_end())
            }
            Self::Chapter(command) => write!(f, "the chapter ends here: `{command}` failed."),
            Self::SceneFile(failure) => failure.fmt(f),
            Self::Model(mistake) => mistake.fmt(f),
            Self::Bake(failure) => write!(f, "the scene cannot be baked: {failure}."),
            Self::Export(unsayable) => write!(f, "the scene cannot be written: {unsayable}."),
            Self::Uncounted(unsayable) => write!(f, "the scene cannot be counted: {unsayable}."),
            Self::FilesToTerminal => f.write_str(
                "the scene has images, meshes or voxels: they are written beside its file, and a terminal has no room for them.\n\
                 `-o FILE.ron` names a file.",
            ),
            Self::Text(error) => write!(f, "the scene cannot be written: {error}."),
            Self::NothingToCompare => f.write_str(
                "there is no scene to compare.\n\
                 Name one, as in `scanray compare simple`, or take `scanray compare --all`.",
            ),
            Self::NoSuchPixel { pixel: [x, y], size: [columns, rows] } => write!(
                f,
                "there is no pixel {x},{y} in {columns}x{rows} pixels.\n\
                 Columns and rows count from 0 at the upper left; `--size` takes another size."
            ),
            Self::Render(error) => write!(f, "the picture cannot be drawn: {error}."),
            Self::Bench(failure) => write!(f, "{failure}"),
            Self::Threads(error) => {
                write!(f, "there are no such threads: {error}.\n`--threads 1` asks for no more than one.")
            }
            Self::Race(fault) => write!(f, "there is no race: {fault}"),
            Self::Serve(fault) => write!(f, "there is no playground: {fault}"),
            Self::New(refusal) => refusal.fmt(f),
            Self::Write(path, error) => {
                write!(f, "cannot write {}: {error}.\n`-o` takes another place.", path.display())
            }
            Self::NoDisplay => f.write_str(
                "there is no display to open a window on: DISPLAY is not set.\n\
                 `scanray render` writes the picture to a file and needs none.",
            ),
            Self::Window(reason) => write!(
                f,
                "the display refuses a window: {reason}.\n\
                 `scanray render --no-window` writes the picture to a file and needs none."
            ),
            Self::Output(error) => write!(f, "cannot print the results: {error}."),
        }
    }
}

impl std::error::Error for Error {}

impl From<io::Error> for Error {
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}

impl From<scene_file::Failure> for Error {
    fn from(failure: scene_file::Failure) -> Self {
        Self::SceneFile(failure)
    }
}

impl From<obj::Mistake> for Error {
    fn from(mistake: obj::Mistake) -> Self {
        Self::Model(mistake)
    }
}

impl From<serve::Fault> for Error {
    fn from(fault: serve::Fault) -> Self {
        Self::Serve(fault)
    }
}

impl From<bake::Failure> for Error {
    fn from(failure: bake::Failure) -> Self {
        Self::Bake(failure)
    }
}

impl From<Unsayable> for Error {
    fn from(unsayable: Unsayable) -> Self {
        Self::Export(unsayable)
    }
}

impl From<ron::Error> for Error {
    fn from(error: ron::Error) -> Self {
        Self::Text(error)
    }
}

impl From<Failure> for Error {
    fn from(failure: Failure) -> Self {
        Self::Bench(failure)
    }
}

impl From<ThreadPoolBuildError> for Error {
    fn from(error: ThreadPoolBuildError) -> Self {
        Self::Threads(error)
    }
}

impl From<race::Fault> for Error {
    fn from(fault: race::Fault) -> Self {
        Self::Race(fault)
    }
}

impl From<boards::Refusal> for Error {
    fn from(refusal: boards::Refusal) -> Self {
        Self::New(refusal)
    }
}

impl From<minifb::Error> for Error {
    fn from(error: minifb::Error) -> Self {
        Self::Window(error.to_string())
    }
}
