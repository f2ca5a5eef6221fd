//! Firmware: a Stellaris LM3S6965 evaluation board draws a ray-traced scene on its OLED of 128x64 pixels and 16 greys.
//!
//! ```text
//! cargo run --release --example lm3s6965_oled --target thumbv7m-none-eabi
//! ```
//!
//! The panel (an SSD0323 on SSI0) is part of the board. How long the frame took goes out on UART0 at 115 200 baud.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(all(target_os = "none", target_arch = "arm", target_has_atomic = "32", target_abi = "eabi"))]
mod firmware;

#[cfg(all(target_os = "none", not(all(target_arch = "arm", target_has_atomic = "32", target_abi = "eabi"))))]
#[path = "../boards/foreign.rs"]
mod foreign;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is firmware. Start it on its emulated board with");
    println!("  cargo run --release --example lm3s6965_oled --target thumbv7m-none-eabi");
}
