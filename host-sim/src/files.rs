//! Where files come from: the disk, or hands that have them ready.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, Cursor, Seek};
use std::path::{Path, PathBuf};

/// Is how many files of a folder are looked at for a name like a missing one.
const MOST_LISTED: usize = 4096;

/// Is a file that is open.
pub struct Open<'a> {
    /// What it holds.
    pub content: Box<dyn Content + 'a>,
    /// How many bytes that is.
    pub bytes: u64,
}

/// Is what a file holds, read from any place on.
pub trait Content: BufRead + Seek {}

impl<T: BufRead + Seek> Content for T {}

/// Is a place that files are read from.
pub trait Files {
    /// Opens a file; none if it is a directory or a device.
    ///
    /// # Errors
    /// Why it is not handed out.
    fn open(&self, path: &Path) -> io::Result<Option<Open<'_>>>;

    /// Answers the one path of a file that many may lead to.
    ///
    /// # Errors
    /// Why there is none.
    fn place(&self, path: &Path) -> io::Result<PathBuf>;

    /// Lists names in the folder of a file, some thousands at most, in alphabetical order.
    fn beside(&self, path: &Path) -> Vec<String>;
}

/// Is the disk.
#[derive(Clone, Copy, Debug)]
pub struct Disk;

impl Files for Disk {
    fn open(&self, path: &Path) -> io::Result<Option<Open<'_>>> {
        // Whoever opens a pipe waits for a writer: look first.
        let about = fs::metadata(path)?;
        if !about.is_file() {
            return Ok(None);
        }
        let content = Box::new(BufReader::new(File::open(path)?));
        Ok(Some(Open { content, bytes: about.len() }))
    }

    fn place(&self, path: &Path) -> io::Result<PathBuf> {
        path.canonicalize()
    }

    fn beside(&self, path: &Path) -> Vec<String> {
        let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
        let entries = fs::read_dir(folder).into_iter().flatten().take(MOST_LISTED).flatten();
        let mut names: Vec<String> =
            entries.filter_map(|entry| entry.file_name().into_string().ok()).collect();
        names.sort_unstable();
        names
    }
}

/// Holds files that were handed over, by their names: of their folders nothing is known, so that a path leads to
/// the file that its last part names.
#[derive(Clone, Debug, Default)]
pub struct Handed {
    files: BTreeMap<String, Vec<u8>>,
}

impl Handed {
    /// Is how many bytes the files may have together: those of the largest grid of voxels and as many again.
    pub const MOST_BYTES: u64 = 1 << 28;

    /// Takes a file, in place of one of the same name; hands it back if there were too many bytes with it.
    ///
    /// # Errors
    /// The file that there is no room for.
    pub fn take(&mut self, name: String, bytes: Vec<u8>) -> Result<(), Vec<u8>> {
        let others = self.files.iter().filter(|(other, _)| **other != name);
        let held: u64 = others.map(|(_, bytes)| bytes.len() as u64).sum();
        if held + bytes.len() as u64 > Self::MOST_BYTES {
            return Err(bytes);
        }
        self.files.insert(name, bytes);
        Ok(())
    }

    /// Finds what a file holds.
    ///
    /// # Errors
    /// There is no file of that name.
    pub fn find(&self, path: &Path) -> io::Result<&[u8]> {
        let name = path.file_name().and_then(|name| name.to_str());
        let bytes = name.and_then(|name| self.files.get(name));
        bytes.map(Vec::as_slice).ok_or(io::ErrorKind::NotFound.into())
    }
}

impl Files for Handed {
    fn open(&self, path: &Path) -> io::Result<Option<Open<'_>>> {
        let bytes = self.find(path)?;
        Ok(Some(Open { content: Box::new(Cursor::new(bytes)), bytes: bytes.len() as u64 }))
    }

    fn place(&self, path: &Path) -> io::Result<PathBuf> {
        self.find(path)?;
        Ok(path.file_name().map(PathBuf::from).unwrap_or_default())
    }

    fn beside(&self, _: &Path) -> Vec<String> {
        self.files.keys().take(MOST_LISTED).cloned().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read;

    #[test]
    fn a_path_leads_to_the_handed_file_that_its_last_part_names() {
        let mut files = Handed::default();
        files.take("wood.png".to_owned(), vec![1, 2, 3]).unwrap();
        for path in ["wood.png", "textures/wood.png", "/a/../wood.png"] {
            let mut open = files.open(Path::new(path)).unwrap().unwrap();
            let mut content = vec![];
            open.content.read_to_end(&mut content).unwrap();
            assert_eq!((content, open.bytes), (vec![1, 2, 3], 3), "{path}");
            assert_eq!(files.place(Path::new(path)).unwrap(), Path::new("wood.png"));
        }
        for path in ["stone.png", "wood.png/stone.png", "", ".."] {
            assert!(files.open(Path::new(path)).is_err_and(|error| error.kind() == io::ErrorKind::NotFound));
        }
    }

    #[test]
    fn a_file_handed_twice_takes_its_own_place_and_one_too_many_is_handed_back() {
        let mut files = Handed::default();
        let large = vec![0; Handed::MOST_BYTES as usize];
        assert!(files.take("x.raw".to_owned(), large).is_ok());
        assert_eq!(files.take("y.raw".to_owned(), vec![7]), Err(vec![7]));
        assert!(files.take("x.raw".to_owned(), vec![8]).is_ok());
        assert!(files.take("y.raw".to_owned(), vec![7]).is_ok());
        assert_eq!(files.beside(Path::new("x.raw")), ["x.raw", "y.raw"]);
    }
}
