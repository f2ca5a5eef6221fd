use super::Fault;
use super::plain::Plain;
use crate::shot::Picture;
use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, Output};
use std::time::Duration;
use std::{fs, io};

/// Is a program that draws scenes.
#[derive(Clone, Copy, Debug)]
pub struct Rival {
    /// Its name, which is the command's too.
    pub name: &'static str,
    /// Debian's package that holds it.
    pub package: &'static str,
    /// What its scene file is called.
    pub(super) scene_file: &'static str,
    /// Writes a scene file.
    pub(super) describe: fn(&Plain) -> String,
    /// Answers what it is started with, of threads, scene file and picture file.
    pub(super) arguments: fn(&Plain, usize, &Path, &Path) -> Vec<OsString>,
    /// What stands before the time that the tracing took, in what it prints.
    pub(super) label: &'static str,
}

/// Is a picture with the time its tracing took.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The picture.
    pub picture: Picture,
    /// From the first ray to the last.
    pub time: Duration,
}

impl Rival {
    /// Has the program draw a view.
    pub(super) fn draw(&self, plain: &Plain, threads: usize) -> Result<Drawn, Fault> {
        let desk = tempfile::tempdir()?;
        let [scene, picture] = [self.scene_file, "picture.png"].map(|name| desk.path().join(name));
        fs::write(&scene, (self.describe)(plain))?;
        let mut command = Command::new(self.name);
        command.args((self.arguments)(plain, threads, &scene, &picture)).current_dir(desk.path());
        let output = command.output().map_err(|error| self.no_start(error))?;
        let said = said(&output);
        let time = time_after(self.label, &said).filter(|_| output.status.success() && picture.exists());
        let time = time.ok_or_else(|| Fault::Rival { program: self.name, says: last_words(&said) })?;
        let image = image::open(&picture)?.into_rgb8();
        let size = [image.width(), image.height()];
        Ok(Drawn { picture: Picture { size, pixels: image.pixels().map(|pixel| pixel.0).collect() }, time })
    }

    fn no_start(&self, error: io::Error) -> Fault {
        match error.kind() {
            io::ErrorKind::NotFound => Fault::NotInstalled { program: self.name, package: self.package },
            _ => Fault::Rival { program: self.name, says: error.to_string() },
        }
    }
}

/// Answers all that a program printed.
fn said(output: &Output) -> String {
    [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text).into_owned()).concat()
}

/// Answers the last lines of what was said: why a program failed stands there.
fn last_words(said: &str) -> String {
    let lines: Vec<&str> = said.lines().collect();
    lines[lines.len().saturating_sub(12)..].join("\n")
}

/// Finds the seconds in the line after a label: the number before the line's last word, which is theirs.
pub(super) fn time_after(label: &str, said: &str) -> Option<Duration> {
    let (_, after) = said.split_once(label)?;
    let (before, _) = after.lines().next()?.rsplit_once(" seconds")?;
    let number = before.rsplit([' ', '(']).next()?;
    Duration::try_from_secs_f64(number.parse().ok()?).ok()
}
