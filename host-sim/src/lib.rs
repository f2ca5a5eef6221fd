//! The scanray core on a desktop: pictures, panels, the reference they are judged by.

pub mod panel;
pub mod picture;
