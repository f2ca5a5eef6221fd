//! The MPS2 board: a counter, the stack, and the host's console by semihosting, with all `unsafe` of this
//! firmware.

use core::ffi::c_void;
use cortex_m_semihosting::{
    debug::{self, EXIT_FAILURE, EXIT_SUCCESS},
    hio, syscall,
};

/// Counts up at 25 MHz from power-up.
const COUNTER: *const u32 = 0x4002_8018 as *const u32;

/// Fills the stack before it is used.
const PAINT: u32 = 0x5ca1_ab1e;

/// Is left unpainted below the stack pointer: the room of the painter itself.
const MARGIN: usize = 256;

/// Stands in for a device's interrupt table, which start-up code asks for where another example brings a
/// device crate.
#[cfg(not(target_has_atomic = "32"))]
// SAFETY: name and section are those the runtime asks for; an interrupt that nobody enables needs no handler.
#[unsafe(no_mangle)]
#[unsafe(link_section = ".vector_table.interrupts")]
pub static __INTERRUPTS: [usize; 1] = [0];

unsafe extern "C" {
    // Only their addresses have a meaning: the linker script's ends of the stack.
    static _stack_end: c_void;
    static _stack_start: c_void;
}

/// Answers the time in ticks of 40 ns; it comes round after 171 s.
pub fn ticks() -> u32 {
    // SAFETY: the counter of the board's FPGA I/O block, aligned, always there, and read without side
    // effects.
    unsafe { COUNTER.read_volatile() }
}

/// Paints the stack that is not in use.
#[inline(never)]
pub fn paint_stack() {
    let end = (cortex_m::register::msp::read() as usize) - MARGIN;
    let mut word = (&raw const _stack_end) as usize;
    while word < end {
        // SAFETY: an aligned word of the stack's memory below everything that lives on it.
        unsafe { (word as *mut u32).write_volatile(PAINT) };
        word += size_of::<u32>();
    }
}

/// Answers how many bytes of the stack have been in use since it was painted.
pub fn stack_used() -> u32 {
    let start = (&raw const _stack_start) as usize;
    let mut word = (&raw const _stack_end) as usize;
    // SAFETY: an aligned word of the stack's memory.
    while word < start && unsafe { (word as *const u32).read_volatile() } == PAINT {
        word += size_of::<u32>();
    }
    (start - word) as u32
}

/// Answers the number that the host's command line ends in, 1 if there is none.
pub fn argument() -> u32 {
    let mut line = [0_u8; 32];
    // SAFETY: pointer and length describe `line`, which the host writes to.
    let refused = unsafe { syscall!(GET_CMDLINE, line.as_mut_ptr(), line.len()) };
    // The host has written behind the compiler's back.
    let line = core::hint::black_box(line);
    let end = line.iter().position(|byte| *byte == 0).unwrap_or(0);
    let digits = line[..end].rsplit(|byte| !byte.is_ascii_digit()).next().unwrap_or_default();
    let number = digits.iter().fold(0_u32, |sum, digit| 10 * sum + u32::from(digit - b'0'));
    if refused == 0 { number.max(1) } else { 1 }
}

/// Prints the parts of a line on the host's console; without a console they are lost.
pub fn print(parts: &[&[u8]]) {
    if let Ok(mut console) = hio::hstdout() {
        for part in parts.iter().chain([&b"\n".as_slice()]) {
            let _ = console.write_all(part);
        }
    }
}

/// Ends the emulation, or sleeps where there is none.
pub fn end(well: bool) -> ! {
    debug::exit(if well { EXIT_SUCCESS } else { EXIT_FAILURE });
    loop {
        cortex_m::asm::wfi();
    }
}
