//! Checksums of the gallery's pictures, kept with the sources: a line for each scene and number.

use super::emulator::Picture;
use super::frames::{self, WAYS};
use crate::bench::{Failure, project};
use crate::scenes::{self, HostNumber};
use rayon::prelude::*;
use scanray::Fixed;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;

/// Begins the file.
const HEAD: &str = "\
# FNV-1a checksums of the gallery, every scene in every way as examples/proof/frames.rs draws it; - is refused by the
# z-buffer. Every chip, the host, debug and release build draw the same bits. Written by `cargo sim prove --update`.
";

/// Rewrites the file.
const UPDATE: &str = "cargo sim prove --update";

/// Holds a checksum for each scene, number and way; none of a picture that the core refuses to draw.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sums(BTreeMap<[String; 3], u32>);

impl Sums {
    /// Reads those that are kept.
    ///
    /// # Errors
    /// A file that is missing or holds something else.
    pub fn read() -> Result<Self, Failure> {
        let failure = |error: String| Failure::File(path(), error);
        let text = std::fs::read_to_string(path()).map_err(|error| failure(error.to_string()))?;
        Self::understand(&text)
            .ok_or_else(|| failure(format!("it is no table of checksums; make one by `{UPDATE}`")))
    }

    /// Draws all pictures on the host.
    pub fn draw() -> Self {
        let scenes: Vec<_> = scenes::all().collect();
        let drawn = scenes.par_iter().flat_map_iter(|entry| {
            let float = sums_of(f32::view(entry), "f32");
            float.chain(sums_of(Fixed::view(entry), "fixed"))
        });
        Self(drawn.collect())
    }

    /// Keeps them and answers where.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(&self) -> Result<PathBuf, Failure> {
        std::fs::write(path(), self.text()).map_err(|error| Failure::File(path(), error.to_string()))?;
        Ok(path())
    }

    /// Answers a complaint for each picture that is not the same in both.
    pub fn changes(&self, kept: &Self) -> Vec<String> {
        let all: BTreeMap<_, _> = self.0.iter().chain(&kept.0).collect();
        let changed = all.into_keys().filter(|name| self.0.get(*name) != kept.0.get(*name));
        changed
            .map(|name| {
                format!("{} is another picture; if it should be, keep it by `{UPDATE}`", name.join(" "))
            })
            .collect()
    }

    /// Answers a complaint for each picture of a number that a chip has drawn otherwise, or not at all.
    pub(super) fn differences(&self, number: &str, pictures: &[Picture]) -> Vec<String> {
        let name = |picture: &Picture| [picture.scene.clone(), number.to_owned(), picture.way.clone()];
        let drawn = Self(pictures.iter().map(|picture| (name(picture), picture.checksum)).collect());
        let kept = self.0.iter().filter(|([_, of, _], _)| of == number);
        let kept = Self(kept.map(|(name, sum)| (name.clone(), *sum)).collect());
        let all: BTreeMap<_, _> = drawn.0.iter().chain(&kept.0).collect();
        let other = all.into_keys().filter(|name| drawn.0.get(*name) != kept.0.get(*name));
        other.map(|[scene, _, way]| format!("{scene}, {way} is not the host's picture")).collect()
    }

    fn text(&self) -> String {
        let mut text = format!("{HEAD}scene number {}\n", WAYS.join(" "));
        for entry in scenes::all() {
            for number in ["f32", "fixed"] {
                let _ = write!(text, "{} {number}", entry.name());
                for way in WAYS {
                    let name = [entry.name(), number, way].map(str::to_owned);
                    // Writing to a string never fails.
                    let _ = match self.0.get(&name) {
                        Some(sum) => write!(text, " {sum:08x}"),
                        None => write!(text, " -"),
                    };
                }
                text.push('\n');
            }
        }
        text
    }

    fn understand(text: &str) -> Option<Self> {
        let mut lines = text.lines().filter(|line| !line.starts_with('#')).map(|line| line.split(' '));
        let ways: Vec<&str> = lines.next()?.skip(2).collect();
        let mut sums = BTreeMap::new();
        for mut words in lines {
            let (scene, number) = (words.next()?, words.next()?);
            for (way, sum) in ways.iter().zip(words) {
                if sum != "-" {
                    let name = [scene, number, way].map(str::to_owned);
                    sums.insert(name, u32::from_str_radix(sum, 16).ok()?);
                }
            }
        }
        Some(Self(sums))
    }
}

/// Draws a scene in every way.
fn sums_of<S: HostNumber>(
    view: &scanray::gallery::View<S>,
    number: &'static str,
) -> impl Iterator<Item = ([String; 3], u32)> {
    let sums = WAYS.iter().enumerate().filter_map(move |(place, way)| {
        Some(([view.name, number, way].map(str::to_owned), frames::checksum(view, place).ok()?))
    });
    sums.collect::<Vec<_>>().into_iter()
}

fn path() -> PathBuf {
    project().join("host-sim/checksums.txt")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(sum: u32) -> Sums {
        Sums(BTreeMap::from([(["simple", "f32", "exact"].map(str::to_owned), sum)]))
    }

    #[test]
    fn what_is_written_is_read_again() {
        let text = one(0x0012_ab34).text();
        assert!(text.contains("\nsimple f32 0012ab34 - "), "{text}");
        assert_eq!(Sums::understand(&text), Some(one(0x0012_ab34)));
    }

    #[test]
    fn a_picture_that_is_another_or_missing_is_named() {
        assert_eq!(one(1).changes(&one(1)), Vec::<String>::new());
        assert!(one(1).changes(&one(2)).concat().starts_with("simple f32 exact is another picture"));
        assert_eq!(one(1).changes(&Sums::default()).len(), 1);
        let picture = |checksum| Picture { scene: "simple".into(), way: "exact".into(), checksum, stack: 0 };
        assert_eq!(one(1).differences("f32", &[picture(1)]), Vec::<String>::new());
        assert_eq!(one(1).differences("fixed", &[]), Vec::<String>::new());
        assert_eq!(one(1).differences("f32", &[picture(2)]), ["simple, exact is not the host's picture"]);
        assert_eq!(one(1).differences("f32", &[]), ["simple, exact is not the host's picture"]);
    }
}
