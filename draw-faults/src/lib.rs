#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod call;
mod canvas;
mod counting;
mod failing;
mod fallible;
mod logging;
mod once;
mod stalling;
mod strict;

pub use call::Call;
pub use canvas::Canvas;
pub use counting::{Counting, Counts};
pub use failing::{At, Failing};
pub use fallible::Fallible;
pub use logging::Logging;
pub use once::Once;
pub use stalling::Stalling;
pub use strict::Strict;
