//! What a browser asks for.

use super::Fault;
use crate::bench::project;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Is the name of the core, as the page asks for it.
const CORE: &str = "scanray.wasm";

/// Is a file with what a browser has to know of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// The name.
    pub name: String,
    /// What it holds, as a media type (RFC 6838).
    pub kind: &'static str,
    /// What it holds.
    pub bytes: Vec<u8>,
}

/// Holds all files of the playground: nothing else can be asked for.
#[derive(Clone, Debug)]
pub struct Site {
    files: Vec<File>,
}

/// Answers the media type of a file by its name; none of one that is no part of a page.
fn kind(name: &str) -> Option<&'static str> {
    Some(match name.rsplit_once('.')?.1 {
        "html" => "text/html; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "svg" => "image/svg+xml",
        "wasm" => "application/wasm",
        _ => return None,
    })
}

impl Site {
    /// Gathers the page of the project and a core that was built for it.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn gather(core: &Path) -> Result<Self, Fault> {
        let folder = project().join("playground/page");
        let mut files = vec![read(core, CORE)?];
        for name in names(&folder).map_err(|error| Fault::File(folder.clone(), error))? {
            files.push(read(&folder.join(&name), &name)?);
        }
        Ok(Self { files })
    }

    /// Lists the files.
    pub fn files(&self) -> &[File] {
        &self.files
    }

    /// Finds what an address asks for, such as `/` or `/style.css?1`.
    pub fn find(&self, address: &str) -> Option<&File> {
        let path = address.split(['?', '#']).next().unwrap_or_default();
        let name = if path == "/" { "index.html" } else { path.strip_prefix('/')? };
        self.files.iter().find(|file| file.name == name)
    }

    /// Writes the files to a folder, which is made if it is missing; answers how many bytes they have.
    ///
    /// # Errors
    /// A file or folder that cannot be written.
    pub fn write(&self, folder: &Path) -> Result<usize, Fault> {
        let fault = |path: &Path| {
            let path: PathBuf = path.to_owned();
            move |error| Fault::File(path, error)
        };
        fs::create_dir_all(folder).map_err(fault(folder))?;
        for file in &self.files {
            let path = folder.join(&file.name);
            fs::write(&path, &file.bytes).map_err(fault(&path))?;
        }
        Ok(self.files.iter().map(|file| file.bytes.len()).sum())
    }
}

/// Lists the names of a page's files.
fn names(folder: &Path) -> io::Result<Vec<String>> {
    let entries = fs::read_dir(folder)?.collect::<Result<Vec<_>, _>>()?;
    let mut names: Vec<String> =
        entries.into_iter().filter_map(|entry| entry.file_name().into_string().ok()).collect();
    names.retain(|name| kind(name).is_some());
    names.sort_unstable();
    Ok(names)
}

fn read(path: &Path, name: &str) -> Result<File, Fault> {
    let bytes = fs::read(path).map_err(|error| Fault::File(path.to_owned(), error))?;
    // Only files with a kind are gathered.
    Ok(File { name: name.to_owned(), kind: kind(name).unwrap_or("application/octet-stream"), bytes })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn site() -> Site {
        let core = tempfile::NamedTempFile::new().unwrap();
        fs::write(core.path(), b"\0asm").unwrap();
        Site::gather(core.path()).unwrap()
    }

    fn text(file: &File) -> String {
        String::from_utf8_lossy(&file.bytes).into_owned()
    }

    #[test]
    fn the_root_is_the_page_and_nothing_beside_it_can_be_had() {
        let site = site();
        assert_eq!(site.find("/").map(|file| file.name.as_str()), Some("index.html"));
        assert_eq!(site.find("/scanray.wasm?2").map(|file| file.kind), Some("application/wasm"));
        for address in ["/../Cargo.toml", "//etc/passwd", "/page/", "", "main.js", "/nothing.js"] {
            assert_eq!(site.find(address), None, "{address}");
        }
    }

    #[test]
    fn every_file_that_the_page_names_is_there_and_none_is_elsewhere() {
        let site = site();
        let named = |text: &str| -> Vec<String> {
            let begins = ["src=\"", "href=\"", "from '", "new URL('"];
            let after = begins.iter().flat_map(|begin| text.split(begin).skip(1));
            after.filter_map(|rest| Some(rest.split_once(['"', '\''])?.0.to_owned())).collect()
        };
        let pages = site.files().iter().filter(|file| file.kind.starts_with("text/"));
        let all: Vec<String> = pages.flat_map(|file| named(&text(file))).collect();
        assert!(all.len() > 10, "{all:?}");
        for name in all {
            let name = name.trim_start_matches("./");
            assert!(site.find(&format!("/{name}")).is_some(), "{name}");
        }
    }

    #[test]
    fn the_folder_for_another_server_holds_the_same_files() {
        let (site, folder) = (site(), tempfile::tempdir().unwrap());
        let bytes = site.write(&folder.path().join("new")).unwrap();
        let written: Vec<_> = site
            .files()
            .iter()
            .map(|file| fs::read(folder.path().join("new").join(&file.name)).unwrap())
            .collect();
        assert_eq!(written.concat().len(), bytes);
        assert!(written.iter().eq(site.files().iter().map(|file| &file.bytes)));
    }
}
