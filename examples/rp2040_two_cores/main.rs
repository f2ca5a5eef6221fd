//! Firmware: both cores of a Raspberry Pi Pico (RP2040) walk around a scene on an ST7789 panel.
//!
//! ```text
//! cargo run --release --example rp2040_two_cores --target thumbv6m-none-eabi
//! ```
//!
//! The pictures and the wires are those of `rp2040_spin`; the cores trace rows in turn.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(all(target_os = "none", target_arch = "arm", not(target_has_atomic = "32")))]
mod firmware;

#[cfg(all(target_os = "none", not(all(target_arch = "arm", not(target_has_atomic = "32")))))]
#[path = "../boards/foreign.rs"]
mod foreign;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is firmware. Start it on its emulated board with");
    println!("  cargo run --release --example rp2040_two_cores --target thumbv6m-none-eabi");
}
