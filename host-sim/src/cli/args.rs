use super::bake_args::BakeArgs;
use super::cost::CostArgs;
use super::explain::ExplainArgs;
use super::gallery::GalleryArgs;
use super::hierarchies_args::HierarchiesArgs;
use super::lesson::LessonArgs;
use super::look::{Curve, Look, size};
use super::new_args::NewArgs;
use super::parse::{chip, judged};
use super::prove::ProveArgs;
use super::rays::Rays;
use super::serve::ServeArgs;
use crate::bench::Chip;
use crate::panel::Panel;
use crate::shot::Number;
use clap::{Args, Parser, Subcommand};
use std::num::NonZeroUsize;
use std::path::PathBuf;

/// Is the command line.
#[derive(Debug, Parser)]
#[command(
    name = "scanray",
    version,
    about = "Draws the pictures of a ray tracer for microcontroller displays on a desktop",
    after_help = "Without a command it does what `scanray render` does.\n\n\
        Examples:\n  \
        scanray                                     draw the scene `simple` into simple.png\n  \
        scanray list                                see which scenes there are\n  \
        scanray render c-ray --panel mono           draw a scene as a black and white panel shows it\n  \
        scanray export simple -o mine.ron           write a scene as a file, to be changed\n  \
        scanray render mine.ron                     draw the scene of a file\n  \
        scanray bake model.obj -o model.rs          make a model data of a program\n  \
        scanray show three-spheres                  walk around a scene in a window\n  \
        scanray compare --all                       judge every number by the reference"
)]
pub(super) struct Cli {
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// Is what the command line asks for.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Draw a scene, show it, write it to a PNG file and tell what it took
    Render(RenderArgs),
    /// Walk around a scene in a window; H in the window names the keys
    Show(ShowArgs),
    /// Draw a scene in coarse blocks that become finer, into an animated GIF
    Progressive(ProgressiveArgs),
    /// Judge the core's numbers by the f64 reference
    Compare(CompareArgs),
    /// Tell ray by ray how the light of a pixel comes about, in f32 and fixed point beside the reference
    Explain(ExplainArgs),
    /// Count what each pixel costs - rays, shapes asked, operations - and draw it as a map of heat
    Cost(CostArgs),
    /// Draw a scene by the tracer and by the z-buffer side by side, and tell what each has done
    Approaches(ApproachesArgs),
    /// Draw a scene for three panels by each way of rounding, and measure what it does to local means
    Dither(DitherArgs),
    /// Draw the cells that discrete walks through a grid visit: Bresenham's, Cohen's and the tripod
    Walks(WalksArgs),
    /// Measure scenes on emulated chips: instructions, flash, RAM, stack; for work on this project
    Bench(BenchArgs),
    /// Prove of emulated chips that nothing panics and all draw the same bits; for work on this project
    Prove(ProveArgs),
    /// Measure the core against renderers nobody here wrote: povray and tachyon
    Race(RaceArgs),
    /// Measure how the work of a ray grows with the number of things, by each kind of hierarchy
    Hierarchies(HierarchiesArgs),
    /// Write every scene in every number and panel as pages for a web server
    Gallery(GalleryArgs),
    /// Serve the playground: the core in a web page, to pick and write scenes and walk around them
    Serve(ServeArgs),
    /// Write a scene or a model as Rust source, for a program without files
    Bake(BakeArgs),
    /// Tell how a ray tracer works, in short chapters that draw their pictures on the spot
    Lesson(LessonArgs),
    /// Name the scenes of the gallery, and of files
    List(ListArgs),
    /// Write a scene as a file that every command takes in its place, to be changed
    Export(ExportArgs),
    /// Begin firmware of your own: a complete crate for a board and its panel
    New(NewArgs),
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray render\n  \
    scanray render c-ray --number fixed --size 160x120 -o small.png\n  \
    scanray render mirror-levels --depth 4 --panel gray4\n  \
    scanray render three-spheres --samples 3 --adaptive-samples")]
pub(super) struct RenderArgs {
    #[command(flatten)]
    pub look: Look,
    /// File to write the picture to [default: SCENE.png in the current directory]
    #[arg(short, long, value_name = "FILE.png")]
    pub output: Option<PathBuf>,
    /// Threads that trace it; any number draws the same picture [default: one for each core]
    #[arg(long, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
    /// Show the picture in the terminal even where a window could be opened
    #[arg(long)]
    pub no_window: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray show\n  \
    scanray show orthographic --panel gray4\n  \
    scanray show simple --spin\n\n\
    Drag or arrow keys orbit, the wheel or + and - zoom, H names all other keys, Esc closes.")]
pub(super) struct ShowArgs {
    #[command(flatten)]
    pub look: Look,
    /// Let the camera walk around by itself
    #[arg(long)]
    pub spin: bool,
    /// Close the window by itself after this many frames
    #[arg(long, hide = true, value_name = "N")]
    pub frames: Option<u64>,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray progressive three-spheres\n  \
    scanray progressive c-ray --number fixed --block 32 -o c-ray.gif\n\n\
    A frame is shown for each 1/32 of the rays, so that times are to each other as on a device.")]
pub(super) struct ProgressiveArgs {
    #[command(flatten)]
    pub look: Look,
    /// Pixels along a side of the first blocks, a power of two up to 128
    #[arg(long, value_name = "N", default_value = "16")]
    pub block: u8,
    /// File to write the animation to [default: SCENE.gif in the current directory]
    #[arg(short, long, value_name = "FILE.gif")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray compare simple\n  \
    scanray compare --all --panel rgb565\n  \
    scanray compare --all --json\n  \
    scanray compare --all --quality adaptive --panel rgb565\n  \
    scanray compare --all --samples 3 --adaptive-samples\n  \
    scanray compare c-ray --number fixed -o pictures")]
pub(super) struct CompareArgs {
    /// Scene to compare: one of the gallery, or a file FILE.ron or FILE.nff
    #[arg(value_name = "SCENE", conflicts_with = "all")]
    pub scene: Option<String>,
    /// Compare every scene of the gallery
    #[arg(long)]
    pub all: bool,
    /// Judge this number only: f32, fixed or exact [default: all three]
    #[arg(long, value_parser = judged)]
    pub number: Option<Number>,
    /// Pictures that are adaptive, or sampled at edges, are compared with those that are not
    #[command(flatten)]
    pub rays: Rays,
    /// Colour format in which pixels are compared
    #[arg(long, default_value = "rgb888")]
    pub panel: Panel,
    /// Columns and rows, such as 160x120 [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<[u32; 2]>,
    /// Print the figures as JSON and nothing else; pictures are then written with -o only
    #[arg(long)]
    pub json: bool,
    /// Directory for NAME-compare.png, pictures side by side over their differences
    /// [default: for a single scene the current one, for --all none]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray approaches\n  \
    scanray approaches simple --number fixed --size 128x128 -o both.png")]
pub(super) struct ApproachesArgs {
    /// Scene of the gallery, of spheres, planes, triangles and boxes
    #[arg(value_name = "SCENE", default_value = "z-buffer")]
    pub scene: String,
    /// Number both compute in
    #[arg(long, default_value = "f32", value_parser = judged)]
    pub number: Number,
    /// Columns and rows, such as 160x120 [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<[u32; 2]>,
    /// Colour format of the display
    #[arg(long, default_value = "rgb565")]
    pub panel: Panel,
    /// File for the two pictures [default: SCENE-approaches.png in the current directory]
    #[arg(short, long, value_name = "FILE.png")]
    pub output: Option<PathBuf>,
}

impl CompareArgs {
    /// Answers the numbers that are judged.
    pub fn numbers(&self) -> impl Iterator<Item = Number> + '_ {
        let numbers = Number::ALL.into_iter().filter(|number| *number != Number::Oracle);
        numbers.filter(|number| self.number.is_none_or(|only| only == *number))
    }
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray bench\n  \
    scanray bench --scene c-ray --chip m3\n  \
    scanray bench --profile --scene playdate --chip m0+\n\n\
    It builds firmware from the sources of this project, for the targets thumbv6m-none-eabi,\n\
    thumbv7m-none-eabi and thumbv7em-none-eabihf, and needs qemu-system-arm; the cycles of the m0+\n\
    need Node.js and `npm ci --prefix host-sim/boards`.")]
pub(super) struct BenchArgs {
    /// Measure this scene of the gallery only
    #[arg(long)]
    pub scene: Option<String>,
    /// Measure on this chip only: m4f, m3 or m0+
    #[arg(long, value_parser = chip)]
    pub chip: Option<&'static Chip>,
    /// Print the rows as JSON and nothing else
    #[arg(long)]
    pub json: bool,
    /// Tell where the instructions go instead: by stage, shape and function
    #[arg(long, conflicts_with_all = ["json", "update"])]
    pub profile: bool,
    /// Keep the rows in host-sim/bench.json, by which later ones are judged
    #[arg(long)]
    pub update: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray race\n  \
    scanray race --size 640x480 --runs 3\n\n\
    It needs the programs of Debian's packages povray and tachyon.")]
pub(super) struct RaceArgs {
    /// Columns and rows of the pictures that are timed
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "1280x960")]
    pub size: [u32; 2],
    /// How often each program draws each picture; the fastest run counts
    #[arg(long, value_name = "N", default_value = "5")]
    pub runs: NonZeroUsize,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray list\n  \
    scanray list scenes/*.ron")]
pub(super) struct ListArgs {
    /// Files to name the scenes of, instead of the gallery's
    #[arg(value_name = "FILE.ron")]
    pub scenes: Vec<String>,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray export simple\n  \
    scanray export c-ray -o mine.ron\n  \
    scanray export scenes/nff/balls2.nff\n\n\
    docs/scene-format.md says what such a file may hold.")]
pub(super) struct ExportArgs {
    /// Scene of the gallery, or a file: FILE.ron is laid out anew, FILE.nff is translated
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// File to write the scene to, its images beside it as FILE-*.png; `-` writes a scene without images to
    /// the terminal [default: SCENE.ron in the current directory]
    #[arg(short, long, value_name = "FILE.ron")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray dither three-spheres\n  \
    scanray dither color-chart --transfer linear -o sheet.png")]
pub(super) struct DitherArgs {
    /// Scene of the gallery; `scanray list` names them
    #[arg(value_name = "SCENE", default_value = "simple")]
    pub scene: String,
    /// Columns and rows of each picture, such as 160x120 [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<[u32; 2]>,
    /// How light becomes levels [default: the scene's]
    #[arg(long, value_enum)]
    pub transfer: Option<Curve>,
    /// File to write the sheet of pictures to [default: SCENE-dither.png in the current directory]
    #[arg(short, long, value_name = "FILE.png")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(super) struct WalksArgs {
    /// File to write the picture to
    #[arg(short, long, value_name = "FILE.png", default_value = "walks.png")]
    pub output: PathBuf,
}
