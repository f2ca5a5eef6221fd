//! A RISC-V core: its start, its stack pointer and its way to the host.

use core::arch::{asm, global_asm};

// The emulator has put all sections where they belong, and memory that nobody wrote to is zero: there is nothing to
// be done before Rust but to name a stack. Whatever faults goes to the handler.
global_asm!(
    ".section .text.start",
    ".global _start",
    "_start:",
    "la t0, 1f",
    "csrw mtvec, t0",
    "la sp, _stack_start",
    "j {start}",
    // The lowest two bits of the handler's address say how it is called, and have to be zero.
    ".balign 4",
    "1: la sp, _stack_start",
    "j {fault}",
    fault = sym fault,
    start = sym start,
);

extern "C" fn start() -> ! {
    super::prove()
}

extern "C" fn fault() -> ! {
    super::host::write("failed: the processor faulted\n");
    super::host::end(false)
}

/// Answers the address of the end of the stack in use.
#[inline(always)]
pub fn stack_pointer() -> usize {
    let pointer;
    // SAFETY: a register is read.
    unsafe { asm!("mv {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags)) };
    pointer
}

/// Calls the host, which reads the argument or what it points to.
pub fn call(operation: usize, argument: usize) {
    // SAFETY: the calls made here read one byte at most, and the host writes to one register alone. The three
    // instructions mark the call together, and none of them may be a compressed one.
    unsafe {
        asm!(
            ".option push",
            ".option norvc",
            ".balign 16",
            "slli x0, x0, 0x1f",
            "ebreak",
            "srai x0, x0, 7",
            ".option pop",
            inout("a0") operation => _,
            in("a1") argument,
            options(nostack, readonly),
        );
    }
}
