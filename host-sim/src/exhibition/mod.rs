//! An exhibition: every scene in every number on every panel, as pages for any web server.
//!
//! A page for each scene shows its pictures, how far each is from the reference's, what it costs and the RAM it takes; the
//! page of the entrance leads to them. Pages have no scripts and ask for nothing from elsewhere.

mod page;
mod room;

pub use room::{Room, Unhung, Work};

use crate::bench::Snapshot;
use crate::cost::{What, heat};
use crate::png;
use crate::shot::Picture;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Is an exhibition that is being put up in a folder, room by room.
#[derive(Debug)]
pub struct Exhibition {
    folder: PathBuf,
    measured: Snapshot,
    /// What the entrance says of each room so far.
    cards: Vec<page::Card>,
}

impl Exhibition {
    /// Begins an exhibition in a folder, which is made if it is not there; `measured` is what scenes cost on chips.
    ///
    /// # Errors
    /// What the file system says.
    pub fn new(folder: &Path, measured: Snapshot) -> io::Result<Self> {
        fs::create_dir_all(folder)?;
        Ok(Self { folder: folder.to_owned(), measured, cards: vec![] })
    }

    /// Writes the page of a scene and its pictures.
    ///
    /// # Errors
    /// What the file system says, and a second scene of the same name.
    pub fn open(&mut self, room: &Room) -> io::Result<()> {
        let name = room.shot.scene.name();
        if self.cards.iter().any(|card| card.name() == name) {
            let why = format!("two scenes are called {name}");
            return Err(io::Error::new(io::ErrorKind::AlreadyExists, why));
        }
        let folder = self.folder.join(name);
        fs::create_dir_all(&folder)?;
        let write = |file: String, picture: &Picture| png::write(&folder.join(file), picture);
        for work in &room.works {
            write(work.file(), &work.picture)?;
            if let Some(difference) = &work.difference {
                write(work.difference_file(), difference)?;
            }
        }
        if let Some(shown) = room.works.first() {
            write("rays.png".into(), &heat(&room.map, What::Rays, &shown.picture))?;
        }
        // A file may have the name of a scene of the gallery.
        let is_known = room.shot.scene.file.is_none();
        let rows: Vec<_> = self.measured.0.iter().filter(|row| is_known && row.scene == name).collect();
        fs::write(folder.join("index.html"), page::room(room, &rows))?;
        self.cards.push(page::Card::of(room));
        Ok(())
    }

    /// Writes the page of the entrance and the style of all pages, and answers the entrance's path.
    ///
    /// # Errors
    /// What the file system says.
    pub fn close(self) -> io::Result<PathBuf> {
        fs::write(self.folder.join("style.css"), include_str!("style.css"))?;
        let entrance = self.folder.join("index.html");
        fs::write(&entrance, page::entrance(&self.cards))?;
        Ok(entrance)
    }
}
