//! Which key and which movement of the mouse does what.

use super::state::Action;
pub use crate::orbit::{STEP, ZOOM};
use minifb::Key;

/// Names the keys, as the help shows them.
pub const HELP: [[&str; 2]; 12] = [
    ["drag, arrows", "orbit"],
    ["wheel, + -", "zoom"],
    ["space", "spin, stop"],
    ["N", "number"],
    ["P", "panel"],
    ["D, Shift-D", "deeper, less"],
    ["1 - 9", "depth"],
    ["T", "transfer"],
    ["R", "reset"],
    ["S", "save PNG"],
    ["H, ?", "this help"],
    ["Q, Esc", "quit"],
];

/// Is what the keyboard tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// A key went down, or is held and repeats.
    Press(Key),
    /// A key went up.
    Release(Key),
    /// A key wrote a character: it follows its [`Event::Press`].
    Letter(char),
}

/// Knows which keys are down, so that a held one does not toggle.
#[derive(Clone, Debug, Default)]
pub struct Keyboard {
    down: Vec<Key>,
    repeats: bool,
}

impl Keyboard {
    /// Answers what an event does. Letters count by what they write, so that every layout of keys
    /// serves.
    pub fn action(&mut self, event: Event) -> Option<Action> {
        let action = match event {
            Event::Press(key) => {
                self.repeats = self.down.contains(&key);
                if !self.repeats {
                    self.down.push(key);
                }
                by_key(key)
            }
            Event::Release(key) => {
                self.down.retain(|down| *down != key);
                None
            }
            Event::Letter(letter) => by_letter(letter),
        }?;
        let moves = matches!(action, Action::Orbit(..) | Action::Zoom(_));
        (moves || !self.repeats).then_some(action)
    }
}

fn by_key(key: Key) -> Option<Action> {
    match key {
        Key::Left => Some(Action::Orbit(-STEP, 0.0)),
        Key::Right => Some(Action::Orbit(STEP, 0.0)),
        Key::Up => Some(Action::Orbit(0.0, STEP)),
        Key::Down => Some(Action::Orbit(0.0, -STEP)),
        Key::Escape => Some(Action::Quit),
        _ => None,
    }
}

fn by_letter(letter: char) -> Option<Action> {
    match letter {
        '+' | '=' => Some(Action::Zoom(ZOOM)),
        '-' => Some(Action::Zoom(1.0 / ZOOM)),
        ' ' => Some(Action::Spin),
        'n' | 'N' => Some(Action::NextNumber),
        'p' | 'P' => Some(Action::NextPanel),
        'd' => Some(Action::DeeperBy(1)),
        'D' => Some(Action::DeeperBy(-1)),
        't' | 'T' => Some(Action::NextTransfer),
        'r' | 'R' => Some(Action::Reset),
        's' | 'S' => Some(Action::Save),
        'h' | 'H' | '?' => Some(Action::Help),
        'q' | 'Q' => Some(Action::Quit),
        '1'..='9' => letter.to_digit(10).and_then(|depth| u8::try_from(depth).ok()).map(Action::Depth),
        _ => None,
    }
}

/// Answers what dragging the picture by so many of its pixels does: a drag across the whole
/// height goes half around. The scene follows the hand, so the eye goes the other way.
pub fn drag([right, down]: [f32; 2], height: u32) -> Option<Action> {
    let angle = |pixels: f32| std::f64::consts::PI * (f64::from(pixels) / f64::from(height.max(1)));
    (right != 0.0 || down != 0.0).then(|| Action::Orbit(-angle(right), angle(down)))
}

/// Answers what turning the wheel does.
pub fn wheel(up: f32) -> Option<Action> {
    // Wheels count in different steps; one event is one notch.
    (up != 0.0).then(|| Action::Zoom(if up > 0.0 { ZOOM } else { 1.0 / ZOOM }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn capital_d_takes_back_what_small_d_does() {
        assert_eq!(by_letter('d'), Some(Action::DeeperBy(1)));
        assert_eq!(by_letter('D'), Some(Action::DeeperBy(-1)));
    }

    #[test]
    fn digits_name_depths_and_zero_none() {
        assert_eq!(by_letter('1'), Some(Action::Depth(1)));
        assert_eq!(by_letter('9'), Some(Action::Depth(9)));
        assert_eq!(by_letter('0'), None);
    }

    #[test]
    fn a_held_key_goes_on_walking_but_toggles_once() {
        let mut keyboard = Keyboard::default();
        let walk = Some(Action::Orbit(STEP, 0.0));
        assert_eq!(keyboard.action(Event::Press(Key::Right)), walk);
        assert_eq!(keyboard.action(Event::Press(Key::Right)), walk);
        let mut help = |event| keyboard.action(event);
        assert_eq!(help(Event::Press(Key::H)), None);
        assert_eq!(help(Event::Letter('h')), Some(Action::Help));
        assert_eq!(help(Event::Press(Key::H)), None);
        assert_eq!(help(Event::Letter('h')), None);
        help(Event::Release(Key::H));
        help(Event::Press(Key::H));
        assert_eq!(help(Event::Letter('h')), Some(Action::Help));
    }

    #[test]
    fn every_letter_the_help_names_does_something() {
        for [keys, _] in HELP {
            let letters = keys.split([',', ' ']).filter(|word| word.chars().count() == 1);
            for letter in letters.filter_map(|word| word.chars().next()).filter(|c| !"+-".contains(*c)) {
                assert!(by_letter(letter.to_ascii_lowercase()).is_some(), "{letter}");
            }
        }
    }

    #[test]
    fn a_drag_to_the_right_walks_to_the_left() {
        assert_eq!(drag([60.0, 0.0], 240), Some(Action::Orbit(-std::f64::consts::FRAC_PI_4, 0.0)));
        assert!(matches!(drag([0.0, 5.0], 240), Some(Action::Orbit(_, up)) if up > 0.0));
        assert_eq!(drag([0.0, 0.0], 240), None);
    }

    #[test]
    fn the_wheel_zooms_in_upward_and_out_downward() {
        assert_eq!(wheel(3.0), Some(Action::Zoom(ZOOM)));
        assert_eq!(wheel(-0.5), Some(Action::Zoom(1.0 / ZOOM)));
        assert_eq!(wheel(0.0), None);
    }
}
