//! Firmware: a chip draws the whole gallery, every way there is, and tells by checksums what it drew and how deep
//! its stack grew; `cargo sim prove` builds, inspects, runs and tabulates it.
//!
//! Nothing else is in the image: what it can reach is what rendering can reach, so that a panic anywhere in the
//! image is one of the core's. The number is chosen when it is built, by the environment variable
//! `SCANRAY_NUMBER` (`f32` or `fixed`). There is no panel: everything is said by semihosting.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod firmware;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is firmware. See what it proves by");
    println!("  cargo sim prove");
}
