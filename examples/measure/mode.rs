//! Ways to make a picture: the firmware measures each, the host judges each. A further one is a further line
//! here.

use scanray::{Scalar, Settings};

/// Is a way to make a picture.
pub struct Mode<S> {
    /// Name, as tables show it.
    pub name: &'static str,
    /// Changes the settings of a scene to this way.
    pub settings: fn(Settings<S>) -> Settings<S>,
}

/// Lists the ways to make a picture in a number.
pub trait Modes: Sized + 'static {
    /// Is the list.
    const MODES: &'static [Mode<Self>];
}

impl<S: Scalar + 'static> Modes for S {
    const MODES: &'static [Mode<S>] = &[Mode { name: "exact", settings: |settings| settings }];
}
