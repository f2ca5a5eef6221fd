use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::Write;
use std::time::{Duration, Instant};

/// Is how long work may take in silence.
const PATIENCE: Duration = Duration::from_secs(1);

/// Shows on a terminal's stderr how far long work is; short work passes in silence.
pub(super) struct Progress {
    bar: ProgressBar,
    begin: Instant,
    shown: bool,
}

impl Progress {
    /// Begins work of so many steps.
    pub fn new(steps: u64, what: String) -> Self {
        let bar = ProgressBar::with_draw_target(Some(steps), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {percent}%, {eta} left") {
            bar.set_style(style);
        }
        bar.set_message(what);
        Self { bar, begin: Instant::now(), shown: false }
    }

    /// Counts a finished step.
    pub fn step(&mut self) {
        self.bar.inc(1);
        if !self.shown && self.begin.elapsed() > PATIENCE {
            self.shown = true;
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Tells what is at work; if nobody is there to be told, that stops nothing.
pub(super) fn tell(what: &str) {
    let _ = writeln!(std::io::stderr(), "{what}");
}
