//! What the window shows, and what each action makes of it; knows no window.

use super::orbit::{orbit, pivot, zoom};
use crate::panel::Panel;
use crate::picture::MAX_DEPTH;
use crate::shot::{Number, Shot};
use scanray::{Transfer, Vec3};

/// Names what a user can do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// Walk around the scene: to the right and up, in radians.
    Orbit(f64, f64),
    /// Make things look larger by a factor.
    Zoom(f64),
    /// Take the next number.
    NextNumber,
    /// Take the next panel.
    NextPanel,
    /// Let light meet one more mirror, or one less.
    DeeperBy(i8),
    /// Let light meet so many mirrors.
    Depth(u8),
    /// Take the other transfer curve.
    NextTransfer,
    /// Show the shot the window opened with.
    Reset,
    /// Write the picture to a file.
    Save,
    /// Show the keys, or hide them.
    Help,
    /// Close the window.
    Quit,
}

/// Names what an action asks of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// Nothing has changed.
    Nothing,
    /// The shot has to be taken again.
    Trace,
    /// What is drawn over the picture has changed.
    Overlay,
    /// The picture is to be written.
    Save,
    /// The window is to be closed.
    Quit,
}

/// Is what the window shows.
#[derive(Clone, Debug)]
pub struct State {
    home: Shot,
    pivot: Vec3<f64>,
    shot: Shot,
    help: bool,
}

/// Answers the entry after `current`, the first one after the last.
fn next<T: Copy + PartialEq>(all: &[T], current: T) -> T {
    let place = all.iter().position(|entry| *entry == current).map_or(0, |i| i + 1);
    all.get(place).or(all.first()).copied().unwrap_or(current)
}

impl State {
    /// Makes the state a window opens with.
    pub fn new(shot: Shot) -> Self {
        Self { home: shot, pivot: pivot(shot.scene.double), shot, help: false }
    }

    /// Answers the shot to show.
    pub fn shot(&self) -> &Shot {
        &self.shot
    }

    /// Answers whether the keys are shown.
    pub fn shows_help(&self) -> bool {
        self.help
    }

    /// Does what the user asks for and answers what that takes.
    pub fn apply(&mut self, action: Action) -> Effect {
        match action {
            Action::Quit => Effect::Quit,
            Action::Save => Effect::Save,
            Action::Help => {
                self.help = !self.help;
                Effect::Overlay
            }
            other => self.change(other),
        }
    }

    fn change(&mut self, action: Action) -> Effect {
        let before = (self.shot.camera, self.settings());
        let shot = &mut self.shot;
        match action {
            Action::Orbit(right, up) => shot.camera = orbit(&shot.camera, self.pivot, right, up),
            Action::Zoom(factor) => shot.camera = zoom(&shot.camera, factor),
            Action::NextNumber => shot.number = next(&Number::ALL, shot.number),
            Action::NextPanel => shot.panel = next(&Panel::ALL, shot.panel),
            Action::DeeperBy(levels) => shot.depth = reachable(shot.depth.saturating_add_signed(levels)),
            Action::Depth(depth) => shot.depth = reachable(depth),
            Action::NextTransfer => {
                shot.transfer = next(&[Transfer::Srgb, Transfer::Linear], shot.transfer);
            }
            Action::Reset => *shot = self.home,
            Action::Save | Action::Help | Action::Quit => {}
        }
        if before == (self.shot.camera, self.settings()) { Effect::Nothing } else { Effect::Trace }
    }

    fn settings(&self) -> (Number, Panel, u8, Transfer) {
        (self.shot.number, self.shot.panel, self.shot.depth, self.shot.transfer)
    }
}

/// Answers the depth, or the largest the host has room for.
fn reachable(depth: u8) -> u8 {
    depth.min(u8::try_from(MAX_DEPTH).unwrap_or(u8::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes;

    fn state(name: &str) -> State {
        State::new(Shot::new(scenes::find(name).unwrap()))
    }

    #[test]
    fn number_and_panel_come_round_to_where_they_began() {
        let mut state = state("simple");
        let mut seen = vec![];
        for _ in Number::ALL {
            seen.push(state.shot().number.name());
            assert_eq!(state.apply(Action::NextNumber), Effect::Trace);
        }
        assert_eq!(seen, ["f32", "fixed", "exact", "oracle"]);
        assert_eq!(state.shot().number, Number::F32);
        for _ in Panel::ALL {
            assert_eq!(state.apply(Action::NextPanel), Effect::Trace);
        }
        assert_eq!(state.shot().panel, Panel::Rgb565);
    }

    #[test]
    fn depth_stops_at_nothing_and_at_what_the_host_has_room_for() {
        let mut state = state("simple");
        assert_eq!(state.apply(Action::DeeperBy(-1)), Effect::Trace);
        assert_eq!(state.apply(Action::DeeperBy(-1)), Effect::Nothing);
        for _ in 0..2 * MAX_DEPTH {
            state.apply(Action::DeeperBy(1));
        }
        assert_eq!(usize::from(state.shot().depth), MAX_DEPTH);
        state.apply(Action::Depth(7));
        assert_eq!(state.shot().depth, 7);
    }

    #[test]
    fn reset_brings_everything_back_but_the_help() {
        let mut state = state("c-ray");
        let home = format!("{:?}", state.shot());
        let actions = [
            Action::Orbit(0.4, 0.1),
            Action::Zoom(1.3),
            Action::NextNumber,
            Action::NextPanel,
            Action::Depth(2),
            Action::NextTransfer,
            Action::Help,
        ];
        for action in actions {
            state.apply(action);
        }
        assert_ne!(format!("{:?}", state.shot()), home);
        assert_eq!(state.apply(Action::Reset), Effect::Trace);
        assert_eq!(format!("{:?}", state.shot()), home);
        assert!(state.shows_help());
        assert_eq!(state.apply(Action::Reset), Effect::Nothing);
    }

    #[test]
    fn every_scene_can_be_walked_around_in_every_number() {
        for entry in scenes::all() {
            let mut state = State::new(Shot { size: [16, 12], ..Shot::new(entry) });
            for step in 0..12 {
                state.apply(Action::Orbit(0.6, if step < 6 { 0.4 } else { -0.5 }));
                state.apply(Action::NextNumber);
                let taken = state.shot().take(|_| ());
                assert!(taken.is_ok(), "{}: {:?} {:?}", entry.name(), taken.err(), state.shot().camera);
            }
        }
    }

    #[test]
    fn quitting_saving_and_help_do_not_trace_again() {
        let mut state = state("simple");
        assert_eq!(state.apply(Action::Quit), Effect::Quit);
        assert_eq!(state.apply(Action::Save), Effect::Save);
        assert_eq!(state.apply(Action::Help), Effect::Overlay);
        assert!(state.shows_help());
    }
}
