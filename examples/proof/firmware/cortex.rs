//! An Arm core: its start, its stack pointer and its way to the host.

use core::arch::asm;

/// Stands in for a device's interrupt table, which start-up code asks for where another example brings a
/// device crate.
#[cfg(not(target_has_atomic = "32"))]
// SAFETY: name and section are those the runtime asks for; an interrupt that nobody enables needs no handler.
#[unsafe(no_mangle)]
#[unsafe(link_section = ".vector_table.interrupts")]
pub static __INTERRUPTS: [usize; 1] = [0];

#[cortex_m_rt::entry]
fn main() -> ! {
    super::prove()
}

/// Answers the address of the end of the stack in use.
#[inline(always)]
pub fn stack_pointer() -> usize {
    let pointer;
    // SAFETY: a register is read.
    unsafe { asm!("mov {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags)) };
    pointer
}

/// Calls the host, which reads the argument or what it points to.
pub fn call(operation: usize, argument: usize) {
    // SAFETY: the calls made here read one byte at most, and the host writes to one register alone.
    unsafe {
        asm!("bkpt 0xab", inout("r0") operation => _, in("r1") argument, options(nostack, readonly));
    }
}

// SAFETY: the name and signature are those the runtime asks for; the handler never returns.
#[cortex_m_rt::exception(trampoline = false)]
unsafe fn HardFault() -> ! {
    super::host::write("failed: the processor faulted\n");
    super::host::end(false)
}
