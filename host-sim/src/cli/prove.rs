use super::Error;
use crate::proof::{self, CHIPS, Chip, Choice, NUMBERS, Sums};
use crate::shot::Number;
use clap::Args;
use std::io::Write;

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray prove\n  \
    scanray prove --chip rv32imc --number fixed\n  \
    scanray prove --turns 28 --chip m0+ --number fixed\n  \
    scanray prove --update\n\n\
    It builds firmware from the sources of this project, for the targets thumbv6m-none-eabi,\n\
    thumbv7m-none-eabi, thumbv7em-none-eabihf and riscv32imc-unknown-none-elf, and needs qemu-system-arm\n\
    and qemu-system-riscv32. A minute or two for each chip and number; an update takes seconds.\n\n\
    --turns soaks: the camera of rp2040_spin goes round so often, 72 pictures of 240x240 a turn, and every\n\
    turn must be the host's to the bit. An RP2040 would draw 27 turns in an hour.")]
pub(super) struct ProveArgs {
    /// Prove it of this chip only: m0+, m3, m4f or rv32imc
    #[arg(long, value_parser = chip)]
    pub chip: Option<&'static Chip>,
    /// Prove it of this number only: f32 or fixed
    #[arg(long, value_parser = number)]
    pub number: Option<Number>,
    /// Let the camera turn so often around three-spheres instead, and compare every turn with the host's
    #[arg(long, conflicts_with = "update", value_parser = clap::value_parser!(u32).range(1..))]
    pub turns: Option<u32>,
    /// Keep the checksums of the host's pictures in host-sim/checksums.txt instead, by which later ones are judged
    #[arg(long, conflicts_with_all = ["chip", "number"])]
    pub update: bool,
}

fn chip(text: &str) -> Result<&'static Chip, String> {
    let names = CHIPS.each_ref().map(|chip| chip.name);
    Chip::find(text).ok_or_else(|| format!("the chips are {}", names.join(", ")))
}

fn number(text: &str) -> Result<Number, String> {
    let number = NUMBERS.into_iter().find(|number| number.name() == text);
    number.ok_or_else(|| "the numbers of chips are f32 and fixed".to_owned())
}

/// Proves what is chosen, prints what was found and every complaint.
pub(super) fn run(args: &ProveArgs, out: &mut impl Write) -> Result<(), Error> {
    if args.update {
        let path = Sums::draw().write()?;
        return Ok(writeln!(out, "kept in {}", path.display())?);
    }
    let choice = Choice { chip: args.chip, number: args.number };
    // If nobody is there to be told, that stops nothing.
    let begin = |what: &str| drop(writeln!(std::io::stderr(), "{what}"));
    if let Some(turns) = args.turns {
        for turns in proof::turn(choice, turns, begin)? {
            writeln!(out, "{turns}")?;
        }
        return Ok(());
    }
    let sums = Sums::read()?;
    let proofs = proof::prove(choice, begin)?;
    write!(out, "{}", proof::table(&proofs, &sums))?;
    for complaint in proofs.iter().flat_map(|proof| proof.complaints(&sums)) {
        writeln!(out, "{complaint}")?;
    }
    Ok(())
}
