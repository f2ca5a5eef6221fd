use super::needs::features;
use super::{Chip, Failure};
use crate::bake::source::Source;
use crate::scenes;
use object::{Object, ObjectSection, SectionFlags, SectionKind, elf};
use scanray::Scene;
use serde::Deserialize;
use std::ffi::OsStr;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::{NamedTempFile, TempPath};

/// Takes the place of the target's own flags: every core has the memory of the same board, and names of
/// functions keep their type parameters, which changes no instruction.
const FLAGS: &str =
    "-C link-arg=--nmagic -C link-arg=-Texamples/boards/mps2_an386.ld -C symbol-mangling-version=v0";

/// Is an image of firmware that is measured or inspected.
#[derive(Debug)]
pub struct Image {
    /// Where it lies, as long as this lasts: the next image takes its place among the built ones.
    pub path: TempPath,
}

/// Counts bytes by where they live.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sizes {
    /// Bytes in flash: code, constants, what statics begin with.
    pub flash: u64,
    /// Bytes of statics in RAM.
    pub ram: u64,
}

/// Answers the folder of the project, whose firmware is measured.
pub fn project() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new(""))
}

/// Answers the command that builds an example for a target; `flags` take the place of the target's own.
pub fn cargo(example: &str, target: &str, flags: &str) -> Command {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command
        .args(["build", "--release", "--quiet", "--message-format=json-render-diagnostics"])
        .args(["--example", example, "--target", target])
        .current_dir(project())
        .env("RUSTFLAGS", flags)
        .env_remove("CARGO_ENCODED_RUSTFLAGS");
    command
}

/// Is what cargo says of something it has built, as far as it matters here.
#[derive(Deserialize)]
struct Built {
    executable: Option<PathBuf>,
}

impl Image {
    /// Builds the image of a scene of the gallery for a chip, in a mode, with those features of the core that
    /// the scene needs.
    pub fn build(chip: &Chip, scene: &str, mode: &str) -> Result<Self, Failure> {
        let features = scenes::find(scene).map_or(String::new(), |entry| features(&entry.double.scene));
        Self::link(
            chip,
            &features,
            FLAGS,
            &[("SCANRAY_SCENE", scene.as_ref()), ("SCANRAY_MODE", mode.as_ref())],
        )
    }

    /// Builds the image of a scene that is baked for a chip, in a mode; `scene` tells the features of the core that
    /// it needs.
    pub fn build_baked(
        chip: &Chip,
        source: &Source,
        scene: &Scene<'_, f64>,
        mode: &str,
    ) -> Result<Self, Failure> {
        let failure = |error: std::io::Error| Failure::File("the baked scene".into(), error.to_string());
        let mut file = tempfile::Builder::new().suffix(".rs").tempfile().map_err(failure)?;
        file.write_all(source.items.as_bytes()).map_err(failure)?;
        let flags = format!("{FLAGS} --cfg scanray_baked");
        Self::link(
            chip,
            &features(scene),
            &flags,
            &[("SCANRAY_BAKED", file.path().as_os_str()), ("SCANRAY_MODE", mode.as_ref())],
        )
    }

    fn link(chip: &Chip, features: &str, flags: &str, variables: &[(&str, &OsStr)]) -> Result<Self, Failure> {
        let mut cargo = cargo("measure", chip.target, flags);
        cargo.args(["--no-default-features", "--features", features]);
        Self::built_by(cargo.envs(variables.iter().copied()))
    }

    /// Builds the image that a command of [`cargo`] describes.
    pub fn built_by(command: &mut Command) -> Result<Self, Failure> {
        let output = command.output().map_err(|error| Failure::Start("cargo", error))?;
        let messages = String::from_utf8_lossy(&output.stdout);
        let built = messages.lines().filter_map(|line| serde_json::from_str::<Built>(line).ok());
        match built.filter_map(|built| built.executable).next_back() {
            Some(path) if output.status.success() => Self::keep(&path),
            _ => Err(Failure::Build(String::from_utf8_lossy(&output.stderr).into_owned())),
        }
    }

    fn keep(built: &Path) -> Result<Self, Failure> {
        let failure = |error: std::io::Error| Failure::File(built.to_owned(), error.to_string());
        let path = NamedTempFile::new().map_err(failure)?.into_temp_path();
        std::fs::copy(built, &path).map_err(failure)?;
        Ok(Self { path })
    }

    /// Reads the file.
    pub fn read(&self) -> Result<Vec<u8>, Failure> {
        std::fs::read(&self.path).map_err(|error| Failure::File(self.path.to_path_buf(), error.to_string()))
    }

    /// Counts the bytes that the image takes on the chip.
    pub fn sizes(&self) -> Result<Sizes, Failure> {
        let bytes = self.read()?;
        let file = object::File::parse(&*bytes)
            .map_err(|error| Failure::File(self.path.to_path_buf(), error.to_string()))?;
        let mut sizes = Sizes::default();
        for section in file.sections() {
            let SectionFlags::Elf { sh_flags, .. } = section.flags() else { continue };
            let has = |flag: u32| sh_flags & u64::from(flag) != 0;
            if !has(elf::SHF_ALLOC) {
                continue;
            }
            let in_flash = section.kind() != SectionKind::UninitializedData;
            sizes.flash += if in_flash { section.size() } else { 0 };
            sizes.ram += if has(elf::SHF_WRITE) { section.size() } else { 0 };
        }
        Ok(sizes)
    }
}
