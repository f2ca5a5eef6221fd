use super::{Board, Refusal, TEMPLATES, lock, name};
use include_dir::{Dir, File};
use std::fs;
use std::path::{Path, PathBuf};

/// Is the name of every crate that projects are made of.
const PLACEHOLDER: &str = "my-picture";

/// Is how those crates depend on scanray.
const DEPENDENCY: &str = r#"scanray = { path = "../../.." }"#;

/// Is where a project gets scanray from.
#[derive(Clone, Debug)]
pub enum Source {
    /// The folder of its sources.
    Folder(PathBuf),
    /// The registry crates.io, in a version that goes with this one.
    Published,
}

impl Source {
    /// Answers the sources that this program was built from.
    pub fn here() -> Self {
        Self::Folder(crate::bench::project().to_owned())
    }

    /// Answers the line of `Cargo.toml`.
    fn dependency(&self) -> String {
        match self {
            Self::Folder(path) => format!("scanray = {{ path = {} }}", quoted(&path.to_string_lossy())),
            Self::Published => format!(
                "scanray = \"{}.{}\"",
                env!("CARGO_PKG_VERSION_MAJOR"),
                env!("CARGO_PKG_VERSION_MINOR")
            ),
        }
    }

    /// Refuses sources that are gone, and a project inside them.
    fn check(&self, folder: &Path) -> Result<(), Refusal> {
        let Self::Folder(sources) = self else { return Ok(()) };
        let sources = sources.canonicalize().map_err(|_| Refusal::NoSources(sources.clone()))?;
        let parent =
            folder.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        match parent.canonicalize() {
            Ok(parent) if parent.starts_with(&sources) => Err(Refusal::InsideSources(folder.to_owned())),
            Ok(_) => Ok(()),
            Err(error) => Err(Refusal::Write(parent.to_owned(), error)),
        }
    }
}

/// Writes a complete crate of firmware for a board into a new folder, whose name becomes that of the crate, and answers
/// the name.
pub fn create(board: &Board, folder: &Path, source: &Source) -> Result<String, Refusal> {
    let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
    if !name::is_crate_name(&name) {
        return Err(Refusal::NoCrateName(name));
    }
    let template =
        TEMPLATES.get_dir(board.name).ok_or_else(|| Refusal::UnknownBoard(board.name.to_owned()))?;
    let files = files(template);
    // The template's own name is that of no dependency.
    let taken = |text: &str| name != PLACEHOLDER && lock::lists(text, &name);
    if files.iter().filter_map(|file| file.contents_utf8()).any(taken) {
        return Err(Refusal::TakenName(name));
    }
    if folder.symlink_metadata().is_ok() {
        return Err(Refusal::Exists(folder.to_owned()));
    }
    source.check(folder)?;
    fs::create_dir(folder).map_err(|error| Refusal::Write(folder.to_owned(), error))?;
    let written = files.into_iter().try_for_each(|file| write(file, board, folder, &name, source));
    // Half a project would look like a whole one. The folder is ours: it was not there before.
    written.inspect_err(|_| drop(fs::remove_dir_all(folder))).map(|()| name)
}

/// Answers the files of a template, without what somebody has built there.
fn files(template: &'static Dir<'static>) -> Vec<&'static File<'static>> {
    let folders = template.dirs().filter(|dir| !dir.path().ends_with("target"));
    template.files().chain(folders.flat_map(files)).collect()
}

fn write(file: &File, board: &Board, folder: &Path, name: &str, source: &Source) -> Result<(), Refusal> {
    let path = folder.join(file.path().strip_prefix(board.name).unwrap_or(file.path()));
    let text = String::from_utf8_lossy(file.contents());
    // The name first: the path of the sources may hold the placeholder's words.
    let text = text.replace(PLACEHOLDER, name).replace(DEPENDENCY, &source.dependency());
    let text = if path.ends_with("Cargo.lock") { lock::sorted(&text) } else { text };
    let parent = path.parent().unwrap_or(folder);
    fs::create_dir_all(parent)
        .and_then(|()| fs::write(&path, text))
        .map_err(|error| Refusal::Write(path, error))
}

/// Answers a text between quotes, as TOML reads it: what JSON writes is a basic string there.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
