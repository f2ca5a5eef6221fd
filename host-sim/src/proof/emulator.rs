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
    /// Bytes of the stack at its deepest, the workspace included.
    pub stack: u32,
}

/// Lets a chip draw the gallery; answers the bytes of its workspace and the pictures.
pub(super) fn draw(chip: &Chip, image: &Image) -> Result<(u32, Vec<Picture>), Failure> {
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

fn understand(said: &str) -> Option<(u32, Vec<Picture>)> {
    let mut lines = said.lines();
    let workspace = lines.next()?.strip_prefix("workspace ")?.parse().ok()?;
    let pictures = lines.map(|line| {
        let mut words = line.split(' ');
        let mut word = || words.next();
        Some(Picture {
            scene: word()?.to_owned(),
            way: word()?.to_owned(),
            checksum: word()?.parse().ok()?,
            stack: word()?.parse().ok()?,
        })
    });
    Some((workspace, pictures.collect::<Option<_>>()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_that_are_no_picture_are_not_passed_over() {
        let said = "workspace 1564\nsimple exact 4294967295 5560\n";
        let picture =
            Picture { scene: "simple".into(), way: "exact".into(), checksum: u32::MAX, stack: 5560 };
        assert_eq!(understand(said), Some((1564, vec![picture])));
        assert_eq!(understand(&format!("{said}failed: the processor faulted\n")), None);
        assert_eq!(understand("simple exact 1 5560\n"), None);
    }
}
