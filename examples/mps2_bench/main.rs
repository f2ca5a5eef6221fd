//! Firmware: a Cortex-M4F (Arm MPS2 with the AN386 image) renders scenes of 320x240 pixels and says what they cost.
//!
//! ```text
//! cargo run --release --example mps2_bench --target thumbv7em-none-eabihf
//! ```
//!
//! There is no panel: rows go into a buffer, as for a display that is fed by DMA. A debugger with semihosting prints the
//! figures and keeps the pictures, as bytes of Rgb565 in a file for each scene.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(all(target_os = "none", target_arch = "arm", target_abi = "eabihf"))]
mod firmware;

#[cfg(all(target_os = "none", not(all(target_arch = "arm", target_abi = "eabihf"))))]
#[path = "../boards/foreign.rs"]
mod foreign;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is firmware. Start it on its emulated board with");
    println!("  cargo run --release --example mps2_bench --target thumbv7em-none-eabihf");
}
