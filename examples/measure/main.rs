//! Firmware: a Cortex-M renders one scene and says what it costs; `cargo sim bench` builds, runs and
//! tabulates it.
//!
//! Scene and mode are chosen when it is built, by the environment variables `SCANRAY_SCENE` and `SCANRAY_MODE`
//! (`exact`, `adaptive`, `raster` or another that `chosen` names), so that the image holds these alone. With a
//! floating-point unit the number is `f32`, without one it is fixed point. Built with `--cfg scanray_baked` it draws
//! the scene whose source `SCANRAY_BAKED` names, as `cargo sim hierarchies --chip` bakes it, instead of one of the
//! gallery.
//!
//! There is no panel: rows go into a buffer, as for a display that is fed by DMA. Everything is said by
//! semihosting.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(all(target_os = "none", target_arch = "arm"))]
mod firmware;

#[cfg(all(target_os = "none", not(target_arch = "arm")))]
#[path = "../boards/foreign.rs"]
mod foreign;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is firmware. Measure with it by");
    println!("  cargo sim bench");
}
