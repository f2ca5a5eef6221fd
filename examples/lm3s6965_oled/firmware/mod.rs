//! What runs on the board: one frame, a report on UART0, then sleep.

mod board;
#[path = "../../boards/decimal.rs"]
mod decimal;
mod registers;
mod ssd0323;
#[path = "../../boards/watched.rs"]
mod watched;

use core::panic::PanicInfo;

use embedded_graphics::{pixelcolor::Gray4, prelude::*};
use scanray::{Fixed, Renderer, Workspace, gallery::fixed};

use self::{
    board::Uart,
    decimal::Decimal,
    watched::{Stopwatch, Watched},
};

/// Counts the bounces a ray may take.
const DEPTH: usize = 5;

type Space = Workspace<Fixed, Gray4, { ssd0323::WIDTH as usize }, DEPTH>;

#[cortex_m_rt::entry]
fn main() -> ! {
    Uart.write(match show() {
        Ok(()) => b"done\n".as_slice(),
        Err(Failure::Scene) => b"failed: the renderer refuses the scene\n",
        Err(Failure::Panel) => b"failed: the panel refuses an area\n",
    });
    sleep()
}

fn sleep() -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}

/// Says what went wrong.
enum Failure {
    Scene,
    Panel,
}

fn show() -> Result<(), Failure> {
    let (mut panel, mut clock) = board::start().map_err(|_| Failure::Panel)?;
    let view = &fixed::SIMPLE;
    let mut space = Space::new();
    clock.restart();
    let mut target = Watched::new(&mut panel, &mut clock);
    let size = target.bounding_box().size;
    Renderer::new(&view.scene, &view.camera, size, view.settings, &mut space)
        .map_err(|_| Failure::Scene)?
        .draw(&mut target)
        .map_err(|_| Failure::Panel)?;
    clock.sending();
    report(b"rendering", clock.rendering);
    report(b"sending", clock.sending);
    Ok(())
}

fn report(name: &[u8], ticks: u32) {
    for part in [name, b" ", Decimal::new(ticks).as_bytes(), b" cycles of 20 ns\n"] {
        Uart.write(part);
    }
}

#[panic_handler]
fn halt(_: &PanicInfo) -> ! {
    Uart.write(b"failed: the firmware panicked\n");
    sleep()
}

// SAFETY: the name and signature are those the runtime asks for; the handler never returns.
#[cortex_m_rt::exception(trampoline = false)]
unsafe fn HardFault() -> ! {
    Uart.write(b"failed: the processor faulted\n");
    sleep()
}
