//! What the pictures of models show.

use scanray::{
    Fixed,
    gallery::{View, fixed},
};

/// Lists the models: several hundred smooth triangles, and more than ten thousand.
pub static VIEWS: [&View<Fixed>; 2] = [&fixed::TEAPOT, &fixed::KNOT];
