use super::Chip;
use crate::bench::{Failure, Image, PATIENCE, listen};
use std::process::Command;
use std::time::Duration;

/// Is a picture as a chip has drawn it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The scene's name.
    pub scene: String,
    /// The way it was drawn.
    pub way: String,
    /// FNV-1a of the bytes that a panel would get.
    pub checksum: u32,
    /// Bytes of the stack at its deepest, beside the workspace, the row and the renderer.
    pub stack: u32,
}

/// Lets a chip draw the gallery.
pub(super) fn draw(chip: &Chip, image: &Image) -> Result<Vec<Picture>, Failure> {
    let said = run(chip, image, PATIENCE)?;
    understand(&said).ok_or(Failure::Firmware(said))
}

/// Runs an image, at most as long as that, and answers what it says.
pub(super) fn run(chip: &Chip, image: &Image, patience: Duration) -> Result<String, Failure> {
    let mut emulator = Command::new(chip.emulator);
    emulator
        .args(chip.board)
        .args(["-display", "none", "-serial", "none", "-monitor", "none", "-no-reboot"])
        .args(["-chardev", "stdio,id=said", "-semihosting-config", "enable=on,target=native,chardev=said"])
        .arg("-kernel")
        .arg(&image.path);
    listen(chip.emulator, &mut emulator, patience)
}

fn understand(said: &str) -> Option<Vec<Picture>> {
    let pictures = said.lines().map(|line| {
        let mut words = line.split(' ');
        let mut word = || words.next();
        Some(Picture {
            scene: word()?.to_owned(),
            way: word()?.to_owned(),
            checksum: word()?.parse().ok()?,
            stack: word()?.parse().ok()?,
        })
    });
    pictures.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_that_are_no_picture_are_not_passed_over() {
        let said = "simple exact 4294967295 1560\n";
        let picture =
            Picture { scene: "simple".into(), way: "exact".into(), checksum: u32::MAX, stack: 1560 };
        assert_eq!(understand(said), Some(vec![picture]));
        assert_eq!(understand(&format!("{said}failed: the processor faulted\n")), None);
        assert_eq!(understand("simple exact 1\n"), None);
    }
}
