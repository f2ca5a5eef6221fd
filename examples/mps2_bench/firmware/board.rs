//! The MPS2 board: a counter, and the host's console and files by semihosting, with the only `unsafe` blocks of this
//! firmware.

use cortex_m_semihosting::{hio, nr, syscall};

/// Counts up at 25 MHz from power-up.
const COUNTER: *const u32 = 0x4002_8018 as *const u32;

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

/// Is a file on the host, in the folder the debugger was started in.
pub struct File(usize);

impl File {
    /// Creates the file, or empties it. `name` ends in a zero byte.
    pub fn create(name: &core::ffi::CStr) -> Option<Self> {
        // SAFETY: pointer and length describe `name`, which the host only reads.
        let handle = unsafe { syscall!(OPEN, name.as_ptr(), nr::open::W_TRUNC_BINARY, name.count_bytes()) };
        (handle != usize::MAX).then_some(Self(handle))
    }

    /// Appends `bytes`, and says whether all of them arrived.
    #[must_use]
    pub fn write(&mut self, bytes: &[u8]) -> bool {
        // SAFETY: pointer and length describe `bytes`, which the host only reads.
        unsafe { syscall!(WRITE, self.0, bytes.as_ptr(), bytes.len()) == 0 }
    }
}

impl Drop for File {
    fn drop(&mut self) {
        // SAFETY: the handle came from the host and is given back once.
        unsafe { syscall!(CLOSE, self.0) };
    }
}
