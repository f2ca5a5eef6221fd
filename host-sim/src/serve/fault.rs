use std::fmt;
use std::io;
use std::path::PathBuf;

/// Tells what keeps the playground from being served.
#[derive(Debug)]
#[non_exhaustive]
pub enum Fault {
    /// The toolchain cannot compile for browsers.
    NoTarget,
    /// A program that is needed does not start.
    Start(&'static str, io::Error),
    /// The core does not compile for browsers; the compiler has said why.
    Build,
    /// A file cannot be read or written.
    File(PathBuf, io::Error),
    /// Nobody can listen at this port.
    Port(u16, String),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoTarget => f.write_str(
                "the toolchain cannot compile for browsers yet. This teaches it:\n\
                 rustup target add wasm32-unknown-unknown",
            ),
            Self::Start(program, error) => {
                write!(f, "{program} does not start: {error}.\nIt comes with Rust: https://rustup.rs")
            }
            Self::Build => {
                f.write_str("the core does not compile for browsers; the compiler says why above.")
            }
            Self::File(path, error) => write!(f, "{}: {error}.", path.display()),
            Self::Port(port, why) => {
                write!(f, "nobody can listen at port {port}: {why}.\n`--port 0` takes any that is free.")
            }
        }
    }
}

impl std::error::Error for Fault {}
