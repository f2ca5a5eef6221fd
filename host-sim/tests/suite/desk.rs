//! The built program, run in a directory of a test's own.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub struct Desk(pub PathBuf);

impl Desk {
    pub fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("scanray-cli-{test}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub fn run(&self, arguments: &str) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_scanray"));
        command.args(arguments.split_whitespace()).current_dir(&self.0).env_remove("DISPLAY");
        command.output().unwrap()
    }

    pub fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

impl Drop for Desk {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

pub fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

pub fn read(path: &Path) -> (Vec<[u8; 3]>, [u32; 2]) {
    let picture = image::open(path).unwrap().into_rgb8();
    (picture.pixels().map(|pixel| pixel.0).collect(), [picture.width(), picture.height()])
}

/// Demands exit code 2, nothing on stdout, and an error that says all this.
pub fn assert_refused(desk: &Desk, arguments: &str, says: &[&str]) {
    let output = desk.run(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments}: {output:?}");
    assert_eq!(stdout(&output), "", "{arguments}");
    for word in says {
        assert!(stderr(&output).contains(word), "{arguments} does not say {word:?}: {}", stderr(&output));
    }
    assert!(!stderr(&output).contains("panicked"), "{}", stderr(&output));
}
