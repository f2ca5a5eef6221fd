//! Stands in for a board's firmware on a target that is another board's: it links, starts and sleeps.
//!
//! With it `cargo build --examples` works for every target, although each image fits one board alone.

use core::panic::PanicInfo;

// The RP2040's linker script asks for an interrupt table, which its device crate brings.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
use rp2040_hal as _;

#[cfg(target_arch = "arm")]
#[cortex_m_rt::entry]
fn sleep() -> ! {
    loop {
        core::hint::spin_loop();
    }
}

#[panic_handler]
fn halt(_: &PanicInfo) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
