use super::super::emulator::{self, QEMU};
use super::super::image::Image;
use super::super::{Chip, Failure};
use super::calls::{Counts, Walk};
use super::symbols::Symbols;
use std::collections::HashMap;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};

/// Is the function that renders a picture: what it executes is counted.
const RENDER: &str = "firmware::render";

/// Runs each `stride`th row of the image and counts the executed addresses of the picture.
pub fn trace(chip: &Chip, image: &Image, symbols: &Symbols<'_>, stride: u32) -> Result<Counts, Failure> {
    let missing = || Failure::Firmware(format!("it has no function {RENDER}"));
    let render = symbols.address_of(RENDER).ok_or_else(missing)?;
    let mut qemu = start(chip, image, stride)?;
    let counts = match qemu.stderr.take() {
        Some(log) => picture(BufReader::with_capacity(1 << 20, log), symbols, render),
        None => Ok(Counts::default()),
    };
    // It would go on with the checksum.
    let _ = qemu.kill();
    let _ = qemu.wait();
    counts
}

fn start(chip: &Chip, image: &Image, stride: u32) -> Result<Child, Failure> {
    let mut qemu = emulator::qemu(chip, image, stride);
    qemu.args(["-d", "exec,nochain"]).args(one_instruction_a_block()?);
    qemu.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    qemu.spawn().map_err(|error| Failure::Start(QEMU, error))
}

/// Answers how this QEMU is told to log each instruction: the option has another name since version 8.1.
fn one_instruction_a_block() -> Result<&'static [&'static str], Failure> {
    let output = Command::new(QEMU).arg("--version").output().map_err(|error| Failure::Start(QEMU, error))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let version = text.split_whitespace().find_map(|word| {
        let (major, rest) = word.split_once('.')?;
        let (minor, _) = rest.split_once('.')?;
        Some((major.parse::<u32>().ok()?, minor.parse::<u32>().ok()?))
    });
    let is_old = version.is_some_and(|version| version < (8, 1));
    Ok(if is_old { &["-singlestep"] } else { &["-accel", "tcg,one-insn-per-tb=on"] })
}

/// Counts the addresses of the first picture.
fn picture(mut log: impl BufRead, symbols: &Symbols<'_>, render: u32) -> Result<Counts, Failure> {
    let mut known = HashMap::new();
    let mut read = |address| *known.entry(address).or_insert_with(|| symbols.instruction(address));
    let mut line = vec![];
    let mut last = 0;
    let mut picture: Option<(Walk, u32)> = None;
    loop {
        line.clear();
        let length = log.read_until(b'\n', &mut line).map_err(|error| Failure::Start(QEMU, error))?;
        if length == 0 {
            return Err(Failure::Firmware("it ends before the picture does".to_owned()));
        }
        let Some(address) = executed(&line) else { continue };
        if let Some((mut walk, back)) = picture.take() {
            if address == back {
                return Ok(walk.counts);
            }
            walk.step(address, read(address));
            picture = Some((walk, back));
        } else if address == render {
            let mut walk = Walk::default();
            walk.step(address, read(address));
            picture = Some((walk, last + read(last).length));
        }
        last = address;
    }
}

/// Reads the address of `Trace 0: 0x7faed4000100 [00800400/00000048/00000110/ff000201] Reset`.
fn executed(line: &[u8]) -> Option<u32> {
    let at = line.iter().position(|byte| *byte == b'/')?;
    let digits = line.get(at + 1..at + 9)?;
    u32::from_str_radix(str::from_utf8(digits).ok()?, 16).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_address_is_the_second_field() {
        let line = b"Trace 0: 0x7faed4000100 [00800400/00000048/00000110/ff000201] Reset\n";
        assert_eq!(executed(line), Some(0x48));
        assert_eq!(executed(b"qemu-system-arm: warning: something\n"), None);
    }
}
