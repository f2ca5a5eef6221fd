//! Ways of rounding compared: by what they do to the means that the eye takes of neighbouring pixels.

mod local_mean;
mod method;
mod void_and_cluster;

pub use local_mean::{Window, error};
pub use method::Method;
pub use void_and_cluster::void_and_cluster;
