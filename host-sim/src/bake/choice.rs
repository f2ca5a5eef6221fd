use super::source::{Literal, Written};
use super::{Bounds, Bvh};
use clap::ValueEnum;
use scanray::accel::Every;

/// Names a kind of hierarchy.
///
/// To add one: a variant, its arms in [`Choice::build`] and [`Choice::build_in_place`], and its [`Written`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Choice {
    /// A tree of boxes.
    #[default]
    Bvh,
    /// None: everything is asked.
    None,
}

/// Is a hierarchy that was built, in a number.
#[derive(Clone, Debug)]
pub struct Ordered<S: Literal> {
    /// The order in which it takes the things to be listed; none if it takes them as they are.
    pub order: Option<Vec<u16>>,
    /// The hierarchy.
    pub tree: &'static dyn Written<S>,
}

impl Choice {
    /// Builds a hierarchy over things that lie in boxes, at most 65535; it stays in memory as long as the
    /// program runs.
    pub fn build<S: Literal>(self, boxes: &[Bounds]) -> Ordered<S> {
        match self {
            Self::Bvh => {
                let bvh = Bvh::build(boxes);
                let tree = Box::leak(Box::new(bvh.leak_in_order()));
                Ordered { order: Some(bvh.order), tree }
            }
            Self::None => Ordered { order: None, tree: self.build_in_place(boxes) },
        }
    }

    /// Builds a hierarchy over things that keep their order, as [`Choice::build`] does.
    pub fn build_in_place<S: Literal>(self, boxes: &[Bounds]) -> &'static dyn Written<S> {
        match self {
            Self::Bvh => Box::leak(Box::new(Bvh::build(boxes).leak())),
            Self::None => Box::leak(Box::new(Every(boxes.len() as u16))),
        }
    }
}
