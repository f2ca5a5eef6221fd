//! The window itself: hands what the user does to a session and shows its frames.

use super::keys::{self, Event, Keyboard};
use super::session::Session;
use super::state::Action;
use crate::shot::{Picture, Shot};
use minifb::{InputCallback, Key, MouseButton, MouseMode, Scale, Window, WindowOptions};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};

/// Answers whether there is a display to open a window on.
pub fn has_display() -> bool {
    // The window speaks X11 where X11 is spoken; a Wayland session sets the variable as well.
    cfg!(any(windows, target_os = "macos")) || std::env::var_os("DISPLAY").is_some_and(|d| !d.is_empty())
}

/// Opens a window, with a camera that walks around by itself if it is to spin, and stays until it is
/// closed, or for so many frames; answers the files the user saved.
///
/// # Errors
/// Why the display refuses the window.
pub fn run(shot: Shot, spin: bool, frames: Option<u64>) -> Result<Vec<PathBuf>, minifb::Error> {
    let mut session = Session::new(shot);
    if spin {
        session.act(Action::Spin);
    }
    let [columns, rows] = shot.size.map(|side| side as usize);
    let options = WindowOptions { scale: scale(shot.size), ..WindowOptions::default() };
    let mut window = Window::new(&session.title(), columns, rows, options)?;
    window.set_target_fps(60);
    let mut input = Input::of(&mut window);
    let mut left = frames.unwrap_or(u64::MAX);
    while window.is_open() && left > 0 {
        let goes_on = input.actions(&window, shot.size[1]).into_iter().all(|action| session.act(action));
        if !goes_on {
            break;
        }
        let frame = session.frame();
        window.set_title(&session.title());
        window.update_with_buffer(&packed(&frame), columns, rows)?;
        left -= 1;
    }
    Ok(session.into_saved())
}

/// Answers the scale that makes a display's picture large enough to look at.
fn scale([columns, rows]: [u32; 2]) -> Scale {
    match columns.max(rows) {
        0..=60 => Scale::X8,
        61..=160 => Scale::X4,
        161..=480 => Scale::X2,
        _ => Scale::X1,
    }
}

fn packed(picture: &Picture) -> Vec<u32> {
    picture.pixels.iter().map(|[r, g, b]| u32::from_be_bytes([0, *r, *g, *b])).collect()
}

/// Hands on every event: asked once a frame, minifb would miss a key struck during a slow one.
struct Listener(Sender<Event>);

impl InputCallback for Listener {
    fn add_char(&mut self, code: u32) {
        if let Some(letter) = char::from_u32(code) {
            // Without a receiver the window is closing, and nobody cares.
            let _ = self.0.send(Event::Letter(letter));
        }
    }

    fn set_key_state(&mut self, key: Key, down: bool) {
        let _ = self.0.send(if down { Event::Press(key) } else { Event::Release(key) });
    }
}

/// Gathers what keyboard and mouse do.
struct Input {
    events: Receiver<Event>,
    keyboard: Keyboard,
    /// Where the mouse was last, while its button is down.
    grip: Option<(f32, f32)>,
}

impl Input {
    fn of(window: &mut Window) -> Self {
        let (sender, events) = channel();
        window.set_input_callback(Box::new(Listener(sender)));
        Self { events, keyboard: Keyboard::default(), grip: None }
    }

    fn actions(&mut self, window: &Window, rows: u32) -> Vec<Action> {
        let mut actions: Vec<Action> =
            self.events.try_iter().filter_map(|event| self.keyboard.action(event)).collect();
        actions.extend(self.drag(window, rows));
        actions.extend(window.get_scroll_wheel().and_then(|(_, up)| keys::wheel(up)));
        actions
    }

    fn drag(&mut self, window: &Window, rows: u32) -> Option<Action> {
        let held = window.get_mouse_down(MouseButton::Left);
        let here = window.get_mouse_pos(MouseMode::Pass).filter(|_| held);
        let from = std::mem::replace(&mut self.grip, here);
        let ((x, y), (from_x, from_y)) = (here?, from?);
        keys::drag([x - from_x, y - from_y], rows)
    }
}
