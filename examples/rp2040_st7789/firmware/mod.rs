//! What runs on the Pico: one frame, then sleep.

#[path = "../../boards/one_core.rs"]
mod one_core;
#[path = "../../boards/pico/mod.rs"]
mod pico;
#[path = "../../boards/wire.rs"]
mod wire;

use scanray::gallery::fixed;

use self::pico::{SIDE, Space, Tracer};

#[rp2040_hal::entry]
fn main() -> ! {
    let rows = cortex_m::singleton!(: [[[u8; 2]; SIDE]; 2] = [[[0; 2]; SIDE]; 2]);
    let [spare, row] = rows.expect("main runs once").each_mut();
    let (panel, mut lamp, _) = pico::take(spare).expect("a part of the board does not answer");
    let view = &fixed::SIMPLE;
    let mut space = Space::new();
    let mut tracer = Tracer::new(view, &view.camera, &mut space);

    let panel = panel.begin().expect("the panel does not answer");
    let (panel, _) =
        one_core::draw(SIDE as u32, panel, row, |y, row| pico::lit(&mut lamp, || tracer.trace(y, row)));
    panel.end().expect("the panel does not answer");
    pico::sleep()
}
