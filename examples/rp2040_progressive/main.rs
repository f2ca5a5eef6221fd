//! Firmware: a Raspberry Pi Pico (RP2040) draws a scene in coarse blocks that become finer.
//!
//! ```text
//! cargo run --release --example rp2040_progressive --target thumbv6m-none-eabi
//! ```
//!
//! The ST7789 panel shows a picture after 1/256 of the time that all of it takes. The wires are those of
//! `examples/boards/pico`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(all(target_os = "none", target_arch = "arm", not(target_has_atomic = "32")))]
mod firmware;

#[cfg(all(target_os = "none", not(all(target_arch = "arm", not(target_has_atomic = "32")))))]
#[path = "../boards/foreign.rs"]
mod foreign;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is firmware. Start it on its emulated board with");
    println!("  cargo run --release --example rp2040_progressive --target thumbv6m-none-eabi");
}
