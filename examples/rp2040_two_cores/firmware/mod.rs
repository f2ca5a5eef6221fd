//! What runs on the Pico: a turn around the scene on both cores, for good.

#[path = "../../boards/pico/mod.rs"]
mod pico;
#[path = "../../boards/turntable.rs"]
mod turntable;
#[path = "../../boards/two_cores.rs"]
mod two_cores;
#[path = "../../boards/wire.rs"]
mod wire;

use rp2040_hal::multicore::{Multicore, Stack};

use self::{
    pico::{Row, SIDE, Space, Tracer},
    two_cores::{BUFFERS, Mailboxes, Second},
};

/// Holds the second core's stack of 2048 words; a guard below it turns an overflow into a fault.
static STACK: Stack<2048> = Stack::new();

#[rp2040_hal::entry]
fn main() -> ! {
    let rows = cortex_m::singleton!(: [[[u8; 2]; SIDE]; BUFFERS + 2] = [[[0; 2]; SIDE]; BUFFERS + 2]);
    let [spare, mut row, round @ ..] = rows.expect("main runs once").each_mut();
    let mailboxes = cortex_m::singleton!(: Mailboxes<Row> = Mailboxes::new(round));
    let (mut first, second) = mailboxes.expect("main runs once").ends();
    let (mut panel, mut lamp, (mut psm, mut ppb, mut fifo)) =
        pico::take(spare).expect("a part of the board does not answer");

    let mut both = Multicore::new(&mut psm, &mut ppb, &mut fifo);
    let [_, core] = both.cores() else { unreachable!("the chip has two cores") };
    let stack = STACK.take().expect("main runs once");
    core.spawn(stack, move || help(second)).expect("the second core does not answer");

    let mut space = Space::new();
    for camera in turntable::cameras() {
        let mut tracer = Tracer::new(turntable::VIEW, &camera, &mut space);
        panel = panel.begin().expect("the panel does not answer");
        (panel, row) =
            first.draw(SIDE as u32, panel, row, |y, row| pico::lit(&mut lamp, || tracer.trace(y, row)));
    }
    pico::sleep()
}

/// Traces the second core's rows: it finds every camera by itself, so nothing is told between the cores.
fn help(mut second: Second<'_, Row>) {
    let mut space = Space::new();
    for camera in turntable::cameras() {
        let mut tracer = Tracer::new(turntable::VIEW, &camera, &mut space);
        second.draw(SIDE as u32, |y, row| tracer.trace(y, row));
    }
}
