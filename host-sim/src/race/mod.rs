//! Races: the same picture by this renderer and by renderers nobody here wrote.
//!
//! A view is written out as each program's own scene file and drawn with one ray a pixel and the same
//! depth of mirrors. Only the tracing counts: start-up, reading the scene and writing the file do not.

mod balls;
mod fault;
mod plain;
mod povray;
mod rival;
mod tachyon;
mod window;

pub use balls::balls;
pub use fault::Fault;
pub use rival::{Drawn, Rival};

use crate::compare::{Comparison, Figures, Subject};
use crate::panel::Panel;
use crate::picture;
use crate::shot::Picture;
use plain::Plain;
use scanray::gallery::{View, double, float};
use scanray::{Dither, Transfer};
use std::num::NonZeroUsize;
use std::time::{Duration, Instant};

/// Lists the programs this renderer is measured against.
pub const RIVALS: [Rival; 2] = [povray::POVRAY, tachyon::TACHYON];

/// Is the name of this renderer among the others.
const OURS: &str = "scanray";

/// Is a scene that is raced on, in the number that races and in the one it is judged by.
#[derive(Clone, Copy, Debug)]
pub struct Course {
    float: View<f32>,
    double: View<f64>,
}

/// Says how a race is run.
#[derive(Clone, Copy, Debug)]
pub struct Rules {
    /// Columns and rows of the picture that is timed.
    pub size: [u32; 2],
    /// How often each program draws it; the fastest counts.
    pub runs: NonZeroUsize,
}

/// Is how a program did.
#[derive(Clone, Debug)]
pub struct Lap {
    /// The scene's name.
    pub scene: &'static str,
    /// The program's name.
    pub program: &'static str,
    /// How many threads it had.
    pub threads: usize,
    /// How long the tracing took, at best.
    pub time: Duration,
    /// How much longer than this renderer's with as many threads.
    pub ratio: f64,
    /// How far its picture, at the usual size of the scene, is from the reference.
    pub figures: Figures,
}

impl Course {
    /// Lists all.
    pub fn all() -> [Self; 2] {
        let c_ray = Self { float: float::C_RAY, double: double::C_RAY };
        [c_ray, Self { float: balls(), double: balls() }].map(Self::with_common_output)
    }

    /// Answers the name.
    pub fn name(&self) -> &'static str {
        self.double.name
    }

    /// Takes the levels all programs can write: proportional to light and plainly rounded.
    fn with_common_output(mut self) -> Self {
        self.float.settings = self.float.settings.with_transfer(Transfer::Linear).with_dither(Dither::None);
        self.double.settings = self.double.settings.with_transfer(Transfer::Linear).with_dither(Dither::None);
        self
    }

    /// Draws the scene with all programs, on one thread and on as many as the processor has cores.
    ///
    /// # Errors
    /// What keeps a program from drawing it.
    pub fn race(&self, rules: Rules) -> Result<Vec<Lap>, Fault> {
        let figures = self.judge_all(rules.size)?;
        let mut laps = vec![];
        for threads in field() {
            let mut best = ENTRANTS.map(|_| Duration::MAX);
            // In turns: whatever else the computer does slows down all alike.
            for _ in 0..rules.runs.get() {
                for (best, entrant) in best.iter_mut().zip(ENTRANTS) {
                    *best = entrant.draw(self, rules.size, threads)?.time.min(*best);
                }
            }
            let ours = best[0].as_secs_f64();
            laps.extend(ENTRANTS.iter().zip(best).zip(&figures).map(|((entrant, time), figures)| Lap {
                scene: self.name(),
                program: entrant.name(),
                threads,
                time,
                ratio: time.as_secs_f64() / ours,
                figures: figures.clone(),
            }));
        }
        Ok(laps)
    }

    /// Judges the pictures of all programs by the reference, at the scene's usual size or what is less.
    fn judge_all(&self, [columns, rows]: [u32; 2]) -> Result<Vec<Figures>, Fault> {
        let size = [columns.min(self.double.size[0]), rows.min(self.double.size[1])];
        let truth = Comparison::trace(&self.double, self.double.settings, size, |_| ())?;
        let shown = truth.on_panel(Panel::Rgb888);
        let judge = |entrant: &Entrant| {
            let picture = entrant.draw(self, size, 1)?.picture;
            let subject = Subject { scene: self.name(), number: entrant.name(), panel: Panel::Rgb888 };
            Ok(Figures::of(subject, &picture.pixels, &shown, &truth.mask))
        };
        ENTRANTS.iter().map(judge).collect()
    }
}

/// Is one who races.
#[derive(Clone, Copy, Debug)]
enum Entrant {
    Ours,
    Rival(Rival),
}

/// Lists all who race, this renderer first.
const ENTRANTS: [Entrant; 1 + RIVALS.len()] =
    [Entrant::Ours, Entrant::Rival(RIVALS[0]), Entrant::Rival(RIVALS[1])];

impl Entrant {
    fn name(&self) -> &'static str {
        match self {
            Self::Ours => OURS,
            Self::Rival(rival) => rival.name,
        }
    }

    fn draw(&self, course: &Course, size: [u32; 2], threads: usize) -> Result<Drawn, Fault> {
        match self {
            Self::Ours => picture::pool(NonZeroUsize::new(threads))?.install(|| draw(&course.float, size)),
            Self::Rival(rival) => rival.draw(&Plain::of(&course.double, size)?, threads),
        }
    }
}

/// Draws a view with this renderer, down to 8 bits a channel, in the pool it is called in.
fn draw(view: &View<f32>, size: [u32; 2]) -> Result<Drawn, Fault> {
    let begin = Instant::now();
    let film = picture::trace(view, view.settings, size, |_| ())?;
    let pixels = film.on_panel(Panel::Rgb888, view.settings.transfer, view.settings.dither);
    Ok(Drawn { time: begin.elapsed(), picture: Picture { size, pixels } })
}

/// Answers the numbers of threads that are raced with.
fn field() -> Vec<usize> {
    let all = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    if all > 1 { vec![1, all] } else { vec![1] }
}

#[cfg(test)]
mod tests {
    use super::povray::POVRAY;
    use super::rival::time_after;
    use super::tachyon::TACHYON;
    use super::*;

    #[test]
    fn the_time_is_found_in_what_each_program_prints() {
        let povray = "  Photon Time: 0\n  Trace Time:       0 hours  1 minutes  1 seconds (61.039 seconds)\n      using 2 thread(s) with 2.0 CPU-seconds total\n";
        assert_eq!(time_after(POVRAY.label, povray), Some(Duration::from_millis(61_039)));
        let tachyon = "\r 100% complete \n  Ray Tracing Time:     0.7606 seconds\n    Image I/O Time:     0.2703 seconds\n";
        assert_eq!(time_after(TACHYON.label, tachyon), Some(Duration::from_micros(760_600)));
        assert_eq!(time_after(TACHYON.label, povray), None);
    }

    #[test]
    fn a_program_that_is_not_there_is_named_with_its_package() {
        let rival = Rival { name: "no-such-program", package: "its-package", ..POVRAY };
        let view = scanray::gallery::double::C_RAY;
        let fault = rival.draw(&Plain::of(&view, [4, 3]).unwrap(), 1).unwrap_err().to_string();
        assert!(
            fault.contains("no-such-program") && fault.contains("apt-get install its-package"),
            "{fault}"
        );
    }
}
