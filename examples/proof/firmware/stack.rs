//! How deep the stack grows: its free part is painted, and what is not as it was has been in use.

use core::ffi::c_void;

use super::chip::stack_pointer;

/// Fills the stack before it is used.
const PAINT: u32 = 0x5ca1_ab1e;

/// Is left unpainted below the stack pointer: the room of the painter itself, in bytes.
const MARGIN: usize = 64;

unsafe extern "C" {
    // Only its address has a meaning: the linker script's lower end of the stack.
    static _stack_end: c_void;
}

/// Paints the stack that is not in use.
#[inline(never)]
pub fn paint() {
    let end = stack_pointer().wrapping_sub(MARGIN);
    let mut word = (&raw const _stack_end) as usize;
    while word < end {
        // SAFETY: an aligned word of the stack's memory below everything that lives on it.
        unsafe { (word as *mut u32).write_volatile(PAINT) };
        word = word.wrapping_add(size_of::<u32>());
    }
}

/// Answers how many bytes below the caller have been in use since they were painted.
#[inline(never)]
pub fn used() -> u32 {
    let start = stack_pointer();
    let mut word = (&raw const _stack_end) as usize;
    // SAFETY: an aligned word of the stack's memory.
    while word < start && unsafe { (word as *const u32).read_volatile() } == PAINT {
        word = word.wrapping_add(size_of::<u32>());
    }
    start.wrapping_sub(word) as u32
}
