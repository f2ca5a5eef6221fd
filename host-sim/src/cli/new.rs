use super::Error;
use super::new_args::NewArgs;
use crate::bench::project;
use crate::boards::{BOARDS, Board, Source, create, find};
use std::io::Write;
use std::path::Path;

/// Begins a project for a board, or lists the boards.
pub(super) fn run(args: &NewArgs, out: &mut impl Write) -> Result<(), Error> {
    let (Some(board), Some(folder)) = (&args.board, &args.folder) else { return list(out) };
    let board = find(board)?;
    let source = if args.published { Source::Published } else { Source::here() };
    let name = create(board, folder, &source)?;
    tell(board, folder, &name, out)
}

fn list(out: &mut impl Write) -> Result<(), Error> {
    for board in &BOARDS {
        let Board { name, chip, panel, target, number, flash, .. } = board;
        writeln!(out, "{name:<18} {chip}\n{:18} {panel}; {number}, {target}\n{:18} {flash}", "", "")?;
    }
    Ok(())
}

/// Tells what was written, and what to type next.
fn tell(board: &Board, folder: &Path, name: &str, out: &mut impl Write) -> Result<(), Error> {
    let Board { chip, panel, target, number, flash, emulator, .. } = board;
    writeln!(out, "{name}: {chip}, {panel}, in {number}\n")?;
    writeln!(out, "  cd {}", folder.display())?;
    writeln!(out, "  rustup target add {target}")?;
    writeln!(out, "  cargo build --release")?;
    if let Some(emulator) = emulator {
        let run = project().join("host-sim/boards/run");
        writeln!(
            out,
            "  {} {emulator} target/{target}/release/{name}   # on the emulated board",
            run.display()
        )?;
    }
    writeln!(out, "  cargo run --release   # on the board: {flash}")?;
    writeln!(
        out,
        "\nsrc/scene.rs is what it shows; README.md has the wires, and help for a panel that shows something else."
    )?;
    Ok(())
}
