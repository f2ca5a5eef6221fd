//! Firmware: counts the instructions of each arithmetic kernel, in fixed point and in `f32`.
//!
//! ```text
//! examples/kernels/run thumbv6m-none-eabi        # Cortex-M0+
//! examples/kernels/run thumbv7m-none-eabi        # Cortex-M3
//! examples/kernels/run thumbv7em-none-eabihf     # Cortex-M4F
//! ```
//!
//! The board is an emulated Arm MPS2 whose clock counts instructions. The figures contain loading the operands and
//! storing the answer, but not the loop. Kernels are compiled as in a scene: small ones inline, large ones called.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(all(target_os = "none", target_arch = "arm"))]
mod firmware;

#[cfg(all(target_os = "none", not(target_arch = "arm")))]
#[path = "../boards/foreign.rs"]
mod foreign;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is firmware. Start it on its emulated board with");
    println!("  examples/kernels/run thumbv6m-none-eabi");
}
