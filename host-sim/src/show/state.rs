//! What the window shows, and what each action makes of it; knows no window.

use crate::orbit::{orbit, pivot, zoom};
use crate::panel::Panel;
use crate::picture::MAX_DEPTH;
use crate::shot::{Number, Shot};
use crate::turn::Turn;
use scanray::{Transfer, Vec3};

/// Counts the steps of a turn: four seconds at sixty pictures a second.
const STEPS: u16 = 240;

/// Names what a user can do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// Walk around the scene: to the right and up, in radians.
    Orbit(f64, f64),
    /// Make things look larger by a factor.
    Zoom(f64),
    /// Let the camera walk around by itself, or stop it.
    Spin,
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
    spins: bool,
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
        Self { home: shot, pivot: pivot(shot.scene.double), shot, spins: false, help: false }
    }

    /// Answers the shot to show.
    pub fn shot(&self) -> &Shot {
        &self.shot
    }

    /// Answers whether the keys are shown.
    pub fn shows_help(&self) -> bool {
        self.help
    }

    /// Takes the next step of a spinning camera; answers whether there was one to take.
    pub fn advance(&mut self) -> bool {
        if self.spins {
            self.shot.turn = self.shot.turn.next();
        }
        self.spins
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
            Action::Spin => self.spin(),
            Action::Reset => {
                *shot = self.home;
                self.spins = false;
            }
            Action::Save | Action::Help | Action::Quit => {}
        }
        if before == (self.shot.camera, self.settings()) { Effect::Nothing } else { Effect::Trace }
    }

    /// Begins to walk around, or stops: a shot that is part of a turn goes on with that, any other turns
    /// around what there is to see.
    fn spin(&mut self) {
        self.spins = !self.spins;
        if self.shot.turn == Turn::NONE {
            self.shot.turn = Turn::of(STEPS);
            self.shot.camera.center = self.pivot;
        }
    }

    fn settings(&self) -> (Number, Panel, u8, Transfer, Turn) {
        let Shot { number, panel, depth, transfer, turn, .. } = self.shot;
        (number, panel, depth, transfer, turn)
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
            Action::Spin,
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
    fn a_spinning_camera_comes_round_to_the_bit_and_stops_where_it_is() {
        let mut state = state("simple");
        assert!(!state.advance());
        assert_eq!(state.apply(Action::Spin), Effect::Trace);
        let turn = |state: &mut State| {
            let cameras = (0..STEPS).map(|_| {
                state.advance();
                state.shot.turn.carry(&state.shot.camera)
            });
            cameras.collect::<Vec<_>>()
        };
        let first = turn(&mut state);
        assert_eq!(first, turn(&mut state));
        assert!((1..first.len()).all(|i| first[i] != first[i - 1]));
        assert_eq!(state.apply(Action::Spin), Effect::Nothing);
        assert!(!state.advance());
        assert_eq!(Some(&state.shot.turn.carry(&state.shot.camera)), first.last());
    }

    #[test]
    fn a_shot_that_is_part_of_a_turn_spins_on_with_its_steps() {
        let shot = Shot { turn: "2/3".parse().unwrap(), ..Shot::new(scenes::find("tinyraytracer").unwrap()) };
        let mut state = State::new(shot);
        state.apply(Action::Spin);
        state.advance();
        assert_eq!((state.shot.turn, state.shot.camera), (Turn::of(3), shot.camera));
    }

    #[test]
    fn reset_stops_a_spinning_camera() {
        let mut state = state("simple");
        state.apply(Action::Spin);
        state.advance();
        assert_eq!(state.apply(Action::Reset), Effect::Trace);
        assert!(!state.advance());
    }

    #[test]
    fn every_scene_can_be_walked_around_in_every_number() {
        for entry in scenes::all() {
            let mut state = State::new(Shot { size: [16, 12], ..Shot::new(entry) });
            for step in 0..12 {
                state.apply(Action::Orbit(0.6, if step < 6 { 0.4 } else { -0.5 }));
                state.apply(Action::NextNumber);
                if step == 3 {
                    state.apply(Action::Spin);
                }
                state.advance();
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
