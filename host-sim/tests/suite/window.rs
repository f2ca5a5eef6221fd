//! The window on a real display: a virtual one, with keys from outside.
//!
//! Needs `Xvfb`, `xdotool` and `xwd` (Debian: xvfb, xdotool, x11-apps).

use host_sim::panel::Panel;
use host_sim::scenes;
use host_sim::shot::{Picture, Shot};
use host_sim::show::state::{Action, State};
use host_sim::show::{keys, overlay};
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Is a process that ends with the test.
struct Process(Child);

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Is a virtual display with the window on it.
struct Stage {
    display: String,
    program: Process,
    _server: Process,
}

impl Stage {
    fn set(arguments: &[&str]) -> Self {
        let mut server = Command::new("Xvfb");
        // Without -noreset the server starts anew whenever a tool leaves before the window has come.
        server.args(["-displayfd", "1", "-noreset", "-screen", "0", "800x600x24"]);
        let mut server = Process(server.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap());
        let mut number = String::new();
        BufReader::new(server.0.stdout.take().unwrap()).read_line(&mut number).unwrap();
        let display = format!(":{}", number.trim());
        let mut program = Command::new(env!("CARGO_BIN_EXE_scanray"));
        program.args(arguments).env("DISPLAY", &display);
        Self { display, program: Process(program.spawn().unwrap()), _server: server }
    }

    /// Waits for the window and turns the keyboard to it, as no window manager does here.
    fn focus(&self) {
        let find = |stage: &Self| stage.xdotool("search --name ^scanray").lines().next().map(str::to_owned);
        let window = self.wait_for("a window", find);
        self.xdotool(&format!("windowfocus --sync {window}"));
    }

    fn tool(&self, name: &str, arguments: &str) -> Vec<u8> {
        let mut command = Command::new(name);
        command.args(arguments.split_whitespace()).env("DISPLAY", &self.display);
        command.stderr(Stdio::null()).output().unwrap().stdout
    }

    fn xdotool(&self, arguments: &str) -> String {
        String::from_utf8(self.tool("xdotool", arguments)).unwrap()
    }

    /// Waits until something is there, at most ten seconds.
    fn wait_for<T>(&self, what: &str, probe: impl Fn(&Self) -> Option<T>) -> T {
        let begin = Instant::now();
        loop {
            if let Some(found) = probe(self) {
                return found;
            }
            assert!(begin.elapsed() < Duration::from_secs(10), "waited in vain for {what}");
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    /// Waits until the window in the middle of the screen shows a picture, twice as large.
    fn expect(&self, what: &str, picture: &Picture) {
        self.wait_for(what, |stage| stage.shown(picture.size).filter(|shown| shown == picture));
    }

    /// Answers the picture of this size that the window in the middle of the screen shows twice as large.
    fn shown(&self, size: [u32; 2]) -> Option<Picture> {
        let screen = screenshot(&self.tool("xwd", "-root -silent"));
        let [width, height] = size.map(|side| 2 * side);
        let [left, top] = [(800 - width) / 2, (600 - height) / 2];
        let row = |y: u32| screen[(y * 800 + left) as usize..][..width as usize].iter().copied();
        let large = Picture { size: [width, height], pixels: (top..top + height).flat_map(row).collect() };
        let small = large.resized(size);
        (small.resized(large.size) == large).then_some(small)
    }
}

/// Reads what `xwd` writes of a screen with 32 bits a pixel, blue first.
fn screenshot(dump: &[u8]) -> Vec<[u8; 3]> {
    let word = |i: usize| u32::from_be_bytes(dump[4 * i..4 * i + 4].try_into().unwrap()) as usize;
    // The header, as XWDFile.h has it: 0 its size, 19 the number of colours of 12 bytes each.
    let pixels = &dump[word(0) + 12 * word(19)..];
    pixels.chunks_exact(4).map(|bgr| [bgr[2], bgr[1], bgr[0]]).collect()
}

fn picture_of(state: &State) -> Picture {
    state.shot().take(|_| ()).unwrap().picture
}

#[test]
#[ignore = "needs Xvfb; run by .ci/run"]
fn the_window_shows_the_picture_and_keys_change_it() {
    let mut stage = Stage::set(&["show", "simple", "--frames", "3600"]);
    stage.focus();
    let mut state = State::new(Shot::new(scenes::find("simple").unwrap()));
    stage.expect("the picture", &picture_of(&state));

    stage.xdotool("key Right");
    state.apply(Action::Orbit(keys::STEP, 0.0));
    stage.expect("a step to the right", &picture_of(&state));

    stage.xdotool("key p");
    stage.xdotool("key plus");
    state.apply(Action::NextPanel);
    state.apply(Action::Zoom(keys::ZOOM));
    stage.expect("the next panel, larger", &picture_of(&state));

    stage.xdotool("key h");
    let mut with_help = picture_of(&state);
    overlay::help(&mut with_help);
    stage.expect("the help", &with_help);

    stage.xdotool("key question");
    stage.xdotool("key r");
    state.apply(Action::Reset);
    stage.expect("the first picture again", &picture_of(&state));

    stage.xdotool("key Escape");
    let status = stage.program.0.wait().unwrap();
    assert!(status.success(), "{status}");
}

#[test]
#[ignore = "needs Xvfb; run by .ci/run"]
fn dragging_and_the_wheel_move_the_picture() {
    let stage = Stage::set(&["show", "simple", "--frames", "3600"]);
    stage.focus();
    let mut state = State::new(Shot::new(scenes::find("simple").unwrap()));
    stage.expect("the picture", &picture_of(&state));

    stage.xdotool("mousemove 400 300 click 4");
    state.apply(Action::Zoom(keys::ZOOM));
    stage.expect("a notch of the wheel", &picture_of(&state));

    // The window may see the button before the mouse moves or after: both ends are held a while.
    stage.xdotool("mousedown 1 sleep 0.3 mousemove 440 300 sleep 0.3 mouseup 1");
    state.apply(keys::drag([20.0, 0.0], 240).unwrap());
    stage.expect("a drag by twenty pixels of the picture", &picture_of(&state));
}

#[test]
#[ignore = "needs Xvfb; run by .ci/run"]
fn a_spinning_window_stops_on_a_step_of_its_turn() {
    let arguments =
        ["show", "simple", "--size", "192x128", "--panel", "rgb888", "--spin", "--frames", "3600"];
    let stage = Stage::set(&arguments);
    stage.focus();
    let scene = scenes::find("simple").unwrap();
    let mut state = State::new(Shot { size: [192, 128], panel: Panel::Rgb888, ..Shot::new(scene) });
    state.apply(Action::Spin);
    let size = state.shot().size;
    let turn: Vec<Picture> = (0..240)
        .map(|_| {
            state.advance();
            picture_of(&state)
        })
        .collect();
    let step = |stage: &Stage| stage.shown(size).filter(|shown| turn.contains(shown));
    let begin = stage.wait_for("a step of the turn", step);
    stage.wait_for("another step", |stage| step(stage).filter(|shown| *shown != begin));
    stage.xdotool("key space");
    stage.wait_for("rest on a step", |stage| {
        let before = step(stage);
        std::thread::sleep(Duration::from_millis(300));
        before.filter(|before| stage.shown(size).as_ref() == Some(before))
    });
}

#[test]
#[ignore = "needs Xvfb; run by .ci/run"]
fn so_many_frames_and_the_window_closes_by_itself() {
    let mut stage = Stage::set(&["show", "c-ray", "--frames", "60"]);
    assert!(stage.program.0.wait().unwrap().success());
}
