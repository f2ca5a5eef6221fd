use std::{fs, io, path::Path};

/// Is a file that chapters draw from.
#[derive(Clone, Copy, Debug)]
pub struct File {
    /// Its name, without a folder.
    pub name: &'static str,
    bytes: &'static [u8],
}

/// Lists files by folder and name.
macro_rules! files {
    ($($folder:literal: $($name:literal)*;)*) => {
        &[$($(File { name: $name, bytes: include_bytes!(concat!($folder, $name)) }),*),*]
    };
}

/// Lists the files of all chapters: their scenes, and what those name.
const FILES: &[File] = files! {
    "../../lessons/scenes/":
        "01-camera.ron" "02-ball.ron" "03-matte.ron" "04-shadows.ron" "05-highlights.ron"
        "06-chessboard.ron" "07-mirrors.ron" "08-glass.ron" "09-triangles.ron" "10-textures.ron"
        "11-samples.ron" "12-panel.ron" "14-fixed.ron" "15-many.ron" "16-volume.ron" "ball.obj";
    "../../../scenes/": "world.png" "peel.png" "craters.png" "teapot.obj" "orbital.raw";
};

impl File {
    /// Answers whether a text names the file, as a word or in quotes.
    fn is_named_in(&self, text: &str) -> bool {
        text.split([' ', '"', '\n']).any(|word| word == self.name)
    }

    /// Writes the file into a folder, unless there is one of its name: whoever changed that wants to see the
    /// change. Answers whether the one there is another.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn put_into(&self, folder: &Path) -> io::Result<bool> {
        let path = folder.join(self.name);
        match fs::read(&path) {
            Ok(there) => Ok(there != self.bytes),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                fs::write(&path, self.bytes).map(|()| false)
            }
            Err(error) => Err(error),
        }
    }
}

/// Lists the files that a command needs: the scenes it names, and what these name.
pub fn needed(command: &str) -> Vec<File> {
    let scenes = FILES.iter().filter(|file| file.is_named_in(command));
    let text = |scene: &File| String::from_utf8_lossy(scene.bytes).into_owned();
    let texts: Vec<String> = scenes.map(text).collect();
    let is_needed =
        |file: &&File| file.is_named_in(command) || texts.iter().any(|text| file.is_named_in(text));
    FILES.iter().filter(is_needed).copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_needs_its_scene_and_what_the_scene_names_and_nothing_else() {
        let names = |command| needed(command).iter().map(|file| file.name).collect::<Vec<_>>();
        assert_eq!(names("render 02-ball.ron -o 02-ball.png"), ["02-ball.ron"]);
        let textures = ["10-textures.ron", "world.png", "peel.png", "craters.png"];
        assert_eq!(names("render 10-textures.ron"), textures);
        assert_eq!(names("render color-chart -o 13-spectra.png"), [""; 0]);
    }
}
