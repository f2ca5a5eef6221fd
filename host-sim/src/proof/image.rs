use super::Chip;
use crate::bench::{Failure, Image, cargo};
use crate::shot::Number;
use object::{File, Object, ObjectSection, SectionKind};

/// Tells what an image does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Draws the gallery in every way.
    Gallery,
    /// The same, with panics that it never comes to.
    Planted,
    /// Turns the camera around a scene so often.
    Turning(u32),
}

/// Builds the image of a number for a chip.
///
/// Relocations stay in it: they tell which function names which. Functions keep the names of their types.
pub(super) fn build(chip: &Chip, number: Number, kind: Kind) -> Result<Image, Failure> {
    let flags = format!(
        "-C link-arg=--nmagic -C link-arg=--emit-relocs -C link-arg=-T{} -C symbol-mangling-version=v0",
        chip.script
    );
    let mut cargo = cargo("proof", chip.target, &flags);
    cargo
        .env("CARGO_PROFILE_RELEASE_OVERFLOW_CHECKS", "true")
        .env("SCANRAY_NUMBER", number.name())
        .env("SCANRAY_PLANTED", if kind == Kind::Planted { "yes" } else { "no" })
        .env("SCANRAY_TURNS", if let Kind::Turning(turns) = kind { turns.to_string() } else { "no".into() });
    Image::built_by(&mut cargo)
}

/// Counts the bytes of an image's code.
pub(super) fn code_bytes(image: &Image) -> Result<u64, Failure> {
    let bytes = image.read()?;
    let file =
        File::parse(&*bytes).map_err(|error| Failure::File(image.path.to_path_buf(), error.to_string()))?;
    let code = file.sections().filter(|section| section.kind() == SectionKind::Text);
    Ok(code.map(|section| section.size()).sum())
}
