//! Rows dealt out to two cores: the firmware's own code, with threads in place of the cores.

use std::{
    sync::atomic::{AtomicU32, Ordering},
    thread,
    time::Duration,
};

use embedded_graphics::geometry::Size;
use scanray::{Fixed, Renderer, Workspace, gallery::fixed::SIMPLE};

use crate::{
    one_core,
    two_cores::{BUFFERS, Mailboxes},
    wire::Wire,
};

const WIDTH: usize = 48;

/// Counts the pictures of the turn: buffers go round from one to the next.
const FRAMES: u32 = 3;

type Row = Vec<[u8; 2]>;

/// Stands for the panel and DMA, which may read a row as late as the next one comes.
struct Tape {
    sent: Vec<Row>,
    flying: Row,
}

impl Wire<Row> for Tape {
    fn exchange(mut self, full: Row) -> (Self, Row) {
        let out = std::mem::replace(&mut self.flying, full);
        self.sent.push(out.clone());
        (self, out)
    }
}

impl Tape {
    fn new() -> Self {
        Self { sent: Vec::new(), flying: blank() }
    }

    /// Answers all rows of the tape but the spare buffer at its beginning.
    fn rows(mut self) -> Vec<Row> {
        self.sent.push(self.flying);
        self.sent.split_off(1)
    }
}

fn blank() -> Row {
    vec![[0; 2]; WIDTH]
}

/// Draws each picture of the turn with what the last one left: `draw` gets that, the number of the picture
/// and a function that traces its rows.
fn turn<T>(height: u32, begin: T, mut draw: impl FnMut(T, u32, &mut dyn FnMut(u32, &mut Row)) -> T) -> T {
    (0..FRAMES).fold(begin, |left, step| {
        let mut space = Workspace::<Fixed, [u8; 2], 0, 5>::new();
        let (camera, size) = (SIMPLE.camera.turned(step, 8), Size::new(WIDTH as u32, height));
        let mut renderer = Renderer::new(&SIMPLE.scene, &camera, size, SIMPLE.settings, &mut space).unwrap();
        draw(left, step, &mut |y, row: &mut Row| renderer.render_row(y, row).unwrap())
    })
}

fn on_one_core(height: u32) -> Vec<Row> {
    let begin = (Tape::new(), blank());
    let (tape, _) = turn(height, begin, |(tape, row), _, trace| one_core::draw(height, tape, row, trace));
    tape.rows()
}

/// Draws on two threads, of which core `c` takes `pause(c, y)` longer for row `y`; answers the rows, and how
/// often each was traced.
fn on_two_cores(height: u32, pause: impl Fn(u32, u32) -> Duration + Sync) -> (Vec<Row>, Vec<u32>) {
    let traced: Vec<_> = (0..FRAMES * height).map(|_| AtomicU32::new(0)).collect();
    let note = |core: u32, step: u32, y: u32| {
        thread::sleep(pause(core, y));
        traced[(step * height + y) as usize].fetch_add(1, Ordering::Relaxed);
    };
    let mut mailboxes = Mailboxes::new([(); BUFFERS].map(|()| blank()));
    let (mut first, mut second) = mailboxes.ends();
    let help = || {
        turn(height, (), |(), step, trace| {
            second.draw(height, |y, row| {
                note(1, step, y);
                trace(y, row);
            });
        });
    };
    let (tape, _) = thread::scope(|scope| {
        scope.spawn(help);
        turn(height, (Tape::new(), blank()), |(tape, row), step, trace| {
            first.draw(height, tape, row, |y, row| {
                note(0, step, y);
                trace(y, row);
            })
        })
    });
    (tape.rows(), traced.into_iter().map(AtomicU32::into_inner).collect())
}

/// Asserts that two cores with such pauses draw each row once and what one core draws.
fn assert_shared(height: u32, pause: impl Fn(u32, u32) -> Duration + Sync) {
    let (rows, traced) = on_two_cores(height, pause);
    assert!(traced.iter().all(|times| *times == 1), "rows are traced so often: {traced:?}");
    assert!(rows == on_one_core(height), "two cores draw another picture of {height} rows than one");
}

#[test]
fn two_cores_share_out_pictures_of_any_height() {
    for height in [1, 2, 3, 9, 48] {
        assert_shared(height, |_, _| Duration::ZERO);
    }
}

#[test]
fn a_much_slower_core_changes_nothing_but_the_time() {
    for slow in [0, 1] {
        assert_shared(21, |core, _| Duration::from_millis(if core == slow { 3 } else { 0 }));
    }
}

#[test]
fn whatever_the_interleaving_the_picture_is_that_of_one_core() {
    for seed in 0..40_u32 {
        // Knuth's multiplicative hash: pauses of 0 to 255 microseconds, other ones for every row and seed.
        let hash = |core: u32, y: u32| (seed * 977 + 2 * y + core).wrapping_mul(2_654_435_761) >> 24;
        assert_shared(17, |core, y| Duration::from_micros(u64::from(hash(core, y))));
    }
}
