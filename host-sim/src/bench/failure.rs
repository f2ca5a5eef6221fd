use crate::bake::source::Unwritable;
use crate::shot::Refusal;
use std::fmt;
use std::path::PathBuf;

/// Tells what keeps something from being measured.
#[derive(Debug)]
#[non_exhaustive]
pub enum Failure {
    /// The image of a scene for a chip does not build; the compiler says why.
    Build(String),
    /// A program that is needed does not start.
    Start(&'static str, std::io::Error),
    /// The emulated firmware does not say what it should; what was said instead.
    Firmware(String),
    /// An emulated chip draws another picture than the host.
    OtherPicture(String, &'static str),
    /// A file is not what it should be.
    File(PathBuf, String),
    /// The host cannot draw the picture.
    Picture(Refusal),
    /// There is no source for something in a scene.
    Unwritable(Unwritable),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Build(said) => write!(f, "the measuring firmware does not build:\n{said}"),
            Self::Start(program, error) => {
                write!(f, "{program} does not start: {error}.\n{}", advice(program))
            }
            Self::Firmware(said) => write!(f, "the measuring firmware does not end well:\n{said}"),
            Self::OtherPicture(scene, chip) => {
                write!(f, "{scene}: the picture of the {chip} is not the one that the host draws")
            }
            Self::File(path, what) => write!(f, "{}: {what}", path.display()),
            Self::Picture(refusal) => write!(f, "the picture cannot be drawn: {refusal}."),
            Self::Unwritable(unwritable) => unwritable.fmt(f),
        }
    }
}

/// Answers how to come by a program.
fn advice(program: &str) -> &'static str {
    match program {
        "qemu-system-arm" => "Debian and Ubuntu have it: apt-get install qemu-system-arm",
        "qemu-system-riscv32" => "Debian and Ubuntu have it: apt-get install qemu-system-misc",
        "node" => "The emulated RP2040 needs Node.js 18 or newer and: npm ci --prefix host-sim/boards",
        _ => "It comes with Rust: https://rustup.rs",
    }
}

impl std::error::Error for Failure {}

impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Self {
        Self::Picture(refusal)
    }
}

impl From<Unwritable> for Failure {
    fn from(unwritable: Unwritable) -> Self {
        Self::Unwritable(unwritable)
    }
}
