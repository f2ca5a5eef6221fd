use super::image::{Image, project};
use super::{Chip, Failure};
use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Is how long a run may take before it counts as hung.
pub const PATIENCE: Duration = Duration::from_secs(600);

/// The firmware counts at 25 MHz; an instruction, or in the other emulator a cycle, takes a nanosecond.
const COUNTS_PER_TICK: u64 = 40;

/// Is QEMU's command.
pub const QEMU: &str = "qemu-system-arm";

/// Is what the firmware said: a line for each figure of each mode.
#[derive(Debug)]
pub struct Said(String);

impl From<String> for Said {
    fn from(words: String) -> Self {
        Self(words)
    }
}

impl Said {
    /// Answers the figure of a mode.
    pub fn figure(&self, mode: &str, name: &str) -> Result<u32, Failure> {
        let figure =
            |line: &str| line.strip_prefix(mode)?.strip_prefix(' ')?.strip_prefix(name)?.trim().parse().ok();
        self.0.lines().find_map(figure).ok_or_else(|| Failure::Firmware(self.0.clone()))
    }

    /// Answers how many instructions, or cycles, the picture took.
    pub fn count(&self, mode: &str) -> Result<u64, Failure> {
        Ok(u64::from(self.figure(mode, "ticks")?) * COUNTS_PER_TICK)
    }

    /// Answers what stands after a word, on each line that begins with it.
    pub fn lines<'s>(&'s self, word: &'s str) -> impl Iterator<Item = &'s str> {
        self.0.lines().filter_map(move |line| line.strip_prefix(word))
    }
}

/// Answers QEMU with an image on the board of a chip, its firmware's words on standard output.
///
/// The firmware renders each `stride`th row: that is the last word of its command line.
pub fn qemu(chip: &Chip, image: &Image, stride: u32) -> Command {
    let mut qemu = Command::new(QEMU);
    qemu.args(["-M", chip.machine, "-display", "none", "-serial", "none", "-monitor", "none", "-no-reboot"])
        .args([
            "-semihosting-config",
            &format!("enable=on,target=native,arg=measure,arg={stride}"),
            "-kernel",
        ])
        .arg(image.path.as_os_str());
    qemu
}

/// Runs each `stride`th row of the image and counts instructions: with `shift=0` each takes a nanosecond of the
/// board's time.
pub fn count_instructions(chip: &Chip, image: &Image, stride: u32) -> Result<Said, Failure> {
    listen(QEMU, qemu(chip, image, stride).args(["-icount", "shift=0"]), PATIENCE).map(Said)
}

/// Is the binary logarithm of the nanoseconds that an instruction takes where few are counted: so many that the
/// counter goes on with each of them.
const SLOW: u32 = 6;

/// Runs the image so slowly that the counter tells single instructions apart, as [`each`] reads it.
pub fn count_each(chip: &Chip, image: &Image) -> Result<Said, Failure> {
    listen(QEMU, qemu(chip, image, 1).args(["-icount", &format!("shift={SLOW}")]), 3 * PATIENCE).map(Said)
}

/// Answers how many instructions took so many ticks in [`count_each`].
pub fn each(ticks: u64) -> u64 {
    let nanoseconds = ticks * COUNTS_PER_TICK;
    (nanoseconds + (1 << SLOW) / 2) >> SLOW
}

/// Runs each `stride`th row of the image on the emulated RP2040, which counts cycles.
pub fn count_cycles(image: &Image, stride: u32) -> Result<Said, Failure> {
    let script = project().join("host-sim/boards/measure.mjs");
    let mut node = Command::new("node");
    node.arg(script).arg(image.path.as_os_str()).arg(stride.to_string());
    listen("node", &mut node, PATIENCE).map(Said)
}

/// Runs a program to its end, at most so long, and answers what it said.
pub fn listen(name: &'static str, command: &mut Command, patience: Duration) -> Result<String, Failure> {
    let mut child = command
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|error| Failure::Start(name, error))?;
    // They are read while it runs: a pipe that is full would stop it.
    let (said, complained) = (hear(child.stdout.take()), hear(child.stderr.take()));
    let ended_well = wait(&mut child, patience).map_err(|error| Failure::Start(name, error))?;
    let [said, complained] = [said, complained].map(|words| words.join().unwrap_or_default());
    if ended_well { Ok(said) } else { Err(Failure::Firmware(said + &complained)) }
}

/// Reads a pipe to its end; what cannot be read is missing.
fn hear(pipe: Option<impl Read + Send + 'static>) -> JoinHandle<String> {
    std::thread::spawn(|| {
        let mut words = String::new();
        let _ = pipe.map(|mut pipe| pipe.read_to_string(&mut words));
        words
    })
}

/// Waits for the end, at most as long as the patience.
fn wait(child: &mut Child, patience: Duration) -> std::io::Result<bool> {
    let begin = Instant::now();
    while begin.elapsed() < patience {
        if let Some(status) = child.try_wait()? {
            return Ok(status.success());
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    child.kill()?;
    child.wait()?;
    Ok(false)
}
