//! What runs on the Pico: one model after the other, out of flash, then sleep.

#[path = "../../boards/models.rs"]
mod models;
#[path = "../../boards/one_core.rs"]
mod one_core;
#[path = "../../boards/pico/mod.rs"]
mod pico;
#[path = "../../boards/wire.rs"]
mod wire;

use self::pico::{SIDE, Space, Tracer};

#[rp2040_hal::entry]
fn main() -> ! {
    let rows = cortex_m::singleton!(: [[[u8; 2]; SIDE]; 2] = [[[0; 2]; SIDE]; 2]);
    let [spare, mut row] = rows.expect("main runs once").each_mut();
    let (mut panel, mut lamp, _) = pico::take(spare).expect("a part of the board does not answer");
    let mut space = Space::new();
    for view in models::VIEWS {
        let mut tracer = Tracer::new(view, &view.camera, &mut space);
        panel = panel.begin().expect("the panel does not answer");
        (panel, row) =
            one_core::draw(SIDE as u32, panel, row, |y, row| pico::lit(&mut lamp, || tracer.trace(y, row)));
    }
    panel.end().expect("the panel does not answer");
    pico::sleep()
}
