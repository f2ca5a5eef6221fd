//! `scanray`: draws, shows and compares pictures; `scanray --help` tells how.

use std::process::ExitCode;

fn main() -> ExitCode {
    host_sim::cli::run(std::env::args_os())
}
