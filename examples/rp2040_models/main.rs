//! Firmware: a Raspberry Pi Pico (RP2040) draws models of many triangles and balls, out of flash, on an
//! ST7789 panel.
//!
//! ```text
//! cargo run --release --example rp2040_models --target thumbv6m-none-eabi
//! ```
//!
//! A row travels to the panel by DMA while the next is traced. The wires are those of `examples/boards/pico`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(all(target_os = "none", target_arch = "arm", not(target_has_atomic = "32")))]
mod firmware;

#[cfg(all(target_os = "none", not(all(target_arch = "arm", not(target_has_atomic = "32")))))]
#[path = "../boards/foreign.rs"]
mod foreign;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is firmware. Start it on its emulated board with");
    println!("  cargo run --release --example rp2040_models --target thumbv6m-none-eabi");
}
