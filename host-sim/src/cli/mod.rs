//! The command line: what it takes, what it prints, how it fails.

mod adaptive;
mod approaches;
mod args;
mod bake;
mod bake_args;
mod bench;
mod compare;
mod cost;
mod dither;
mod error;
mod explain;
mod export;
mod gallery;
mod hierarchies;
mod hierarchies_args;
mod lesson;
mod list;
mod look;
mod new;
mod new_args;
mod parse;
mod progress;
mod progressive;
mod prove;
mod race;
mod rays;
mod render;
mod report;
mod serve;
mod take;
mod walks;
mod words;

pub use error::Error;

use args::{Cli, Command};
use clap::Parser;
use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

/// Is the exit code of everything the user can put right.
const USER_ERROR: u8 = 2;

/// Does what a command line asks for, prints to stdout and complains to stderr.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let command = match parse(arguments) {
        Ok(command) => command,
        Err(answer) => {
            // Help goes to stdout, complaints to stderr; if neither is read, nothing is lost.
            let _ = answer.print();
            return ExitCode::from(answer.exit_code() as u8);
        }
    };
    match execute(&command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if error.is_closed_pipe() => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "error: {error}");
            ExitCode::from(USER_ERROR)
        }
    }
}

fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Command, clap::Error> {
    let mut arguments: Vec<OsString> = arguments.into_iter().collect();
    // A cargo alias that ends in `--` hands on a second one: `cargo sim -- render`.
    if arguments.get(1).is_some_and(|first| first == "--") {
        arguments.remove(1);
    }
    if arguments.len() < 2 {
        arguments = vec!["scanray".into(), "render".into()];
    }
    let cli = Cli::try_parse_from(arguments)?;
    // Without a command there would be nothing after the name, and that was made `render` above.
    cli.command.map_or_else(|| parse([]), Ok)
}

fn execute(command: &Command) -> Result<(), Error> {
    let mut out = std::io::stdout().lock();
    match command {
        Command::Render(args) => render::run(args, &mut out)?,
        Command::Show(args) => render::show(args, &mut out)?,
        Command::Progressive(args) => progressive::run(args, &mut out)?,
        Command::Compare(args) => compare::run(args, &mut out)?,
        Command::Approaches(args) => approaches::run(args, &mut out)?,
        Command::Cost(args) => cost::run(args, &mut out)?,
        Command::Explain(args) => explain::run(args, &mut out)?,
        Command::Dither(args) => dither::run(args, &mut out)?,
        Command::Walks(args) => walks::run(args, &mut out)?,
        Command::Bench(args) => bench::run(args, &mut out)?,
        Command::Prove(args) => prove::run(args, &mut out)?,
        Command::Race(args) => race::run(args, &mut out)?,
        Command::Hierarchies(args) => hierarchies::run(args, &mut out)?,
        Command::Gallery(args) => gallery::run(args, &mut out)?,
        Command::Serve(args) => serve::run(args, &mut out)?,
        Command::Bake(args) => bake::run(args, &mut out)?,
        Command::Lesson(args) => lesson::run(args, &mut out)?,
        Command::List(args) => list::run(args, &mut out)?,
        Command::Export(args) => export::run(args, &mut out)?,
        Command::New(args) => new::run(args, &mut out)?,
    }
    Ok(out.flush()?)
}
