//! The host's console and the end of the emulation, by semihosting: Arm's calls, which RISC-V has taken over.

use super::chip::call;

/// Writes a byte, the one the argument points to.
const WRITE_BYTE: usize = 0x03;

/// Ends the emulation; the argument says why.
const EXIT: usize = 0x18;

/// Is why a program ends that ends well.
const APPLICATION_EXIT: usize = 0x2_0026;

/// Is why a program ends that does not.
const RUN_TIME_ERROR: usize = 0x2_0023;

/// Writes text on the host's console.
pub fn write(text: &str) {
    for byte in text.as_bytes() {
        call(WRITE_BYTE, core::ptr::from_ref(byte) as usize);
    }
}

/// Ends the emulation.
pub fn end(well: bool) -> ! {
    call(EXIT, if well { APPLICATION_EXIT } else { RUN_TIME_ERROR });
    loop {
        core::hint::spin_loop();
    }
}
