//! Reflection models: how much of the light from one direction goes into another.
//!
//! Each answers a factor f: of light I a surface sends `I kd f` with Lambert's and `I ks f` with one of
//! the others (rows L2 to L5). The cosine at which light arrives is part of the factor, so that what
//! physics calls the reflectance is f / (n.l), in units in which all that arrives comes back white.
//!
//! | model | the same with light and eye exchanged | share of the light that comes back |
//! |---|---|---|
//! | [`lambert`] | f / (n.l): reciprocal | all of it |
//! | [`phong`], [`blinn_phong`] | f itself: not reciprocal | no bound where light grazes |
//! | [`CookTorrance`] | f / (n.l): reciprocal | at most `4 c^2`: less than arrives up to c = 1/2 |
//!
//! All vectors have unit length and point away from the surface.

mod blinn_phong;
mod cook_torrance;
mod lambert;
mod phong;

pub use blinn_phong::blinn_phong;
pub use cook_torrance::{CookTorrance, fresnel};
pub use lambert::lambert;
pub use phong::phong;
