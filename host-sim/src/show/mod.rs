//! The window in which one walks around a scene.
//!
//! [`keys`] says what each key does, [`state`] what that makes of the shot, [`session`] draws it;
//! none of them knows the window.

pub mod keys;
pub mod overlay;
pub mod session;
pub mod state;
mod window;

pub use window::{has_display, run};
