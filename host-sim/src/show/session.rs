//! A session: the state of the window with the picture of it; knows no window.

use super::overlay;
use super::state::{Action, Effect, State};
use crate::png;
use crate::shot::{Picture, Shot, Taken};
use scanray::Transfer;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Is how long a picture may take while it is being moved, before it is drawn coarser.
const PATIENCE: Duration = Duration::from_millis(60);

/// Is how long a message stays.
const READING: Duration = Duration::from_secs(3);

/// Is a state with its picture.
#[derive(Debug)]
pub struct Session {
    state: State,
    picture: Picture,
    /// Whether the picture shows an older state, or the right one coarsely.
    stale: bool,
    coarse: bool,
    per_pixel: Duration,
    message: Option<(String, Instant)>,
    saved: Vec<PathBuf>,
}

impl Session {
    /// Begins with a shot.
    pub fn new(shot: Shot) -> Self {
        let picture = Picture::filled(shot.size, [0; 3]);
        let state = State::new(shot);
        let per_pixel = Duration::ZERO;
        Self { state, picture, stale: true, coarse: false, per_pixel, message: None, saved: vec![] }
    }

    /// Does what the user asks for; answers whether the session goes on.
    pub fn act(&mut self, action: Action) -> bool {
        match self.state.apply(action) {
            Effect::Nothing | Effect::Overlay => {}
            Effect::Trace => self.stale = true,
            Effect::Save => self.save(Path::new("")),
            Effect::Quit => return false,
        }
        true
    }

    /// Brings the picture up to date and answers it with what is written over it.
    ///
    /// A state that has just changed may be drawn coarsely; the next call makes up for that, or shows
    /// the next step of a spinning camera.
    pub fn frame(&mut self) -> Picture {
        if !self.stale {
            self.stale = self.state.advance();
        }
        if self.stale {
            let step = self.step();
            self.trace(step);
        } else if self.coarse {
            self.trace(1);
        }
        let mut frame = self.picture.clone();
        if self.state.shows_help() {
            overlay::help(&mut frame);
        }
        if let Some((text, since)) = &self.message {
            if since.elapsed() < READING {
                overlay::message(&mut frame, text);
            } else {
                self.message = None;
            }
        }
        frame
    }

    /// Answers what the window's title says.
    pub fn title(&self) -> String {
        let shot = self.state.shot();
        let transfer = match shot.transfer {
            Transfer::Srgb => "srgb",
            Transfer::Linear => "linear",
        };
        let (scene, number, panel, depth) =
            (shot.scene.name(), shot.number.name(), shot.panel.name(), shot.depth);
        format!("scanray: {scene}, {number}, {panel}, depth {depth}, {transfer} (H: keys)")
    }

    /// Answers the files written so far.
    pub fn into_saved(self) -> Vec<PathBuf> {
        self.saved
    }

    /// Answers how much coarser a picture that moves is drawn.
    fn step(&self) -> u32 {
        let pixels = self.picture.pixels.len() as u32;
        let time = |step: &u32| self.per_pixel * (pixels / (step * step));
        [1, 2, 4].into_iter().find(|step| time(step) < PATIENCE).unwrap_or(8)
    }

    fn trace(&mut self, step: u32) {
        let full = self.state.shot().size;
        let shot = Shot { size: full.map(|side| (side / step).max(1)), ..*self.state.shot() };
        match shot.take(|_| ()) {
            Ok(Taken { picture, time, .. }) => {
                self.per_pixel = time / (picture.pixels.len() as u32).max(1);
                self.picture = if step == 1 { picture } else { picture.resized(full) };
            }
            Err(refusal) => self.say(refusal.to_string()),
        }
        self.stale = false;
        self.coarse = step > 1;
    }

    fn save(&mut self, directory: &Path) {
        if self.stale || self.coarse {
            self.trace(1);
        }
        let path = free_name(directory, self.state.shot().scene.name());
        match png::write(&path, &self.picture) {
            Ok(()) => {
                self.say(format!("saved {}", path.display()));
                self.saved.push(path);
            }
            Err(error) => self.say(format!("not saved: {error}")),
        }
    }

    fn say(&mut self, text: String) {
        self.message = Some((text, Instant::now()));
    }
}

/// Answers a name that no file has: a view one walked to is not to be lost to the next.
fn free_name(directory: &Path, scene: &str) -> PathBuf {
    let first = directory.join(format!("{scene}-view.png"));
    let others = (2..).map(|n| directory.join(format!("{scene}-view-{n}.png")));
    std::iter::once(first).chain(others).find(|path| !path.exists()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes;

    fn session() -> Session {
        let scene = scenes::find("simple").unwrap();
        Session::new(Shot { size: [32, 24], ..Shot::new(scene) })
    }

    #[test]
    fn the_first_frame_is_the_shot() {
        let scene = scenes::find("simple").unwrap();
        let shot = Shot { size: [32, 24], ..Shot::new(scene) };
        assert_eq!(session().frame(), shot.take(|_| ()).unwrap().picture);
    }

    #[test]
    fn a_slow_picture_is_drawn_coarsely_at_first_and_sharply_at_rest() {
        let mut session = session();
        session.frame();
        session.act(Action::Orbit(0.5, 0.0));
        session.per_pixel = Duration::from_millis(1);
        let moving = session.frame();
        assert!(session.coarse);
        let resting = session.frame();
        assert!(!session.coarse);
        assert_eq!(moving.size, resting.size);
        assert_ne!(moving, resting);
        assert_eq!(resting, session.state.shot().take(|_| ()).unwrap().picture);
    }

    #[test]
    fn a_spinning_camera_shows_every_step_from_the_first() {
        let mut session = session();
        session.act(Action::Spin);
        let turn = session.state.shot().turn;
        for expected in [turn, turn.next(), turn.next().next()] {
            // However long a picture takes here, it is to be drawn sharply.
            session.per_pixel = Duration::ZERO;
            let shown = session.frame();
            assert_eq!(session.state.shot().turn, expected);
            assert_eq!(shown, session.state.shot().take(|_| ()).unwrap().picture);
        }
    }

    #[test]
    fn saving_twice_makes_two_files_without_what_is_written_over_them() {
        let directory = std::env::temp_dir().join(format!("scanray-session-{}", std::process::id()));
        std::fs::create_dir_all(&directory).unwrap();
        let mut session = session();
        session.act(Action::Help);
        session.save(&directory);
        session.save(&directory);
        let saved = session.saved.clone();
        let picture = image::open(&saved[1]).unwrap().into_rgb8();
        let written: Vec<[u8; 3]> = picture.pixels().map(|pixel| pixel.0).collect();
        assert_eq!(written, session.picture.pixels);
        assert_ne!(written, session.frame().pixels);
        assert!(saved[0].ends_with("simple-view.png") && saved[1].ends_with("simple-view-2.png"));
        std::fs::remove_dir_all(&directory).unwrap();
    }

    #[test]
    fn the_title_tells_the_settings() {
        let mut session = session();
        session.act(Action::NextNumber);
        assert_eq!(session.title(), "scanray: simple, fixed, rgb565, depth 1, srgb (H: keys)");
    }
}
