//! The MPS2 board: a counter, and the host's console by semihosting, with the only `unsafe` blocks of this firmware.

use cortex_m_semihosting::{debug, hio};

/// Counts up at 25 MHz from power-up.
const COUNTER: *const u32 = 0x4002_8018 as *const u32;

/// Is how many instructions the emulator, at one a nanosecond, executes in a tick.
pub const INSTRUCTIONS_PER_TICK: u32 = 40;

/// Answers the time in ticks of 40 ns; it comes round after 171 s.
pub fn ticks() -> u32 {
    // SAFETY: the counter of the board's FPGA I/O block, aligned, always there, and read without side effects.
    unsafe { COUNTER.read_volatile() }
}

/// Prints the parts of a line on the debugger's console; without a console they are lost.
pub fn print(parts: &[&[u8]]) {
    if let Ok(mut console) = hio::hstdout() {
        for part in parts.iter().chain([&b"\n".as_slice()]) {
            let _ = console.write_all(part);
        }
    }
}

/// Tells the debugger how it went, which ends the emulator.
pub fn leave(well: bool) -> ! {
    debug::exit(if well { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {
        cortex_m::asm::wfi();
    }
}

// SAFETY: the name and signature are those the runtime asks for; the handler never returns.
#[cortex_m_rt::exception(trampoline = false)]
unsafe fn HardFault() -> ! {
    print(&[b"failed: the processor faulted"]);
    leave(false)
}
