use super::{Bounds, Bvh, Grid, Kd, Octree, Tree};
use crate::rounded::Rounded;
use scanray::accel::{Every, Hierarchy};
use serde::{Deserialize, Serialize};

/// Names the kinds of hierarchies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Accel {
    /// A tree of boxes.
    #[default]
    Bvh,
    /// A tree of planes.
    Kd,
    /// A tree of cubes.
    Octree,
    /// Equal cubes.
    Grid,
    /// None: every thing is asked.
    None,
}

impl Accel {
    /// Lists all.
    pub const ALL: [Self; 5] = [Self::Bvh, Self::Kd, Self::Octree, Self::Grid, Self::None];

    /// Answers the name, as commands take it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bvh => "bvh",
            Self::Kd => "kd",
            Self::Octree => "octree",
            Self::Grid => "grid",
            Self::None => "none",
        }
    }

    /// Builds the hierarchy over things that lie in boxes, at most 65535.
    pub fn build(self, things: &[Bounds]) -> Built {
        match self {
            Self::Bvh => Built::Bvh(Bvh::build(things)),
            Self::Kd => Built::Kd(Kd::build(things)),
            Self::Octree => Built::Octree(Octree::build(things)),
            Self::Grid => Built::Grid(Grid::build(things)),
            Self::None => Built::None(things.len() as u16),
        }
    }
}

/// Is a hierarchy that can be had in every number.
#[derive(Clone, Debug)]
pub enum Built {
    /// A tree of boxes.
    Bvh(Bvh),
    /// A tree of planes.
    Kd(Kd),
    /// A tree of cubes.
    Octree(Octree),
    /// Equal cubes.
    Grid(Grid),
    /// Nothing but how many things there are.
    None(u16),
}

impl Built {
    /// Answers the order in which things are best listed for it; `None` if it takes them as they are.
    pub fn order(&self) -> Option<&[u16]> {
        match self {
            Self::Bvh(bvh) => Some(&bvh.order),
            Self::Kd(_) | Self::Octree(_) | Self::Grid(_) | Self::None(_) => None,
        }
    }

    /// Answers the hierarchy in a number, over things in their own order; its lists live as long as the
    /// program.
    pub fn tree<S: Rounded>(&self) -> Tree<S> {
        match self {
            Self::Bvh(bvh) => Tree::Bvh(bvh.leak()),
            Self::Kd(kd) => Tree::Kd(kd.leak()),
            Self::Octree(octree) => Tree::Octree(octree.leak()),
            Self::Grid(grid) => Tree::Grid(grid.leak()),
            Self::None(count) => Tree::None(Every(*count)),
        }
    }

    /// Answers the hierarchy in a number, over things that are listed in [`Self::order`].
    pub fn tree_in_order<S: Rounded>(&self) -> Tree<S> {
        match self {
            Self::Bvh(bvh) => Tree::Bvh(bvh.leak_in_order()),
            other => other.tree(),
        }
    }

    /// Answers the hierarchy in a number, as the core asks for it; it lives as long as the program.
    pub fn leak<S: Rounded>(&self) -> &'static dyn Hierarchy<S> {
        self.tree().leak()
    }

    /// Counts the bytes that it takes in flash; of a tree of boxes, those of one whose things are listed in
    /// its order.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Bvh(bvh) => bvh.bytes(),
            Self::Kd(kd) => kd.bytes(),
            Self::Octree(octree) => octree.bytes(),
            Self::Grid(grid) => grid.bytes(),
            Self::None(_) => 0,
        }
    }
}
