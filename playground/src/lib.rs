//! The scanray core in a web page.
//!
//! A page hands over a request in JSON and gets an answer in JSON, with pixels beside it where there are any. Nothing
//! of this needs a tool beside cargo: what crosses is numbers and bytes.
//!
//! - [`door`]: the functions that a page calls, the only ones with a C interface.
//! - [`request`], [`answer`], [`fault`]: what crosses it. [`look`]: what decides a picture, with its words.
//! - [`desk`]: does what is asked of the scene on it; [`opening`]: puts one there.
//! - [`walk`]: where a scene is seen from, in whole steps.
//! - [`heat`], [`account`]: what is told of a picture, of a pixel.
#![deny(unsafe_code)]

pub mod account;
pub mod answer;
pub mod desk;
pub mod door;
pub mod fault;
pub mod heat;
pub mod look;
pub mod opening;
pub mod request;
pub mod walk;
