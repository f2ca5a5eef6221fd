use scanray::Scalar;
use scanray::accel::{Bvh, Every, Grid, Hierarchy, Kd, Lists, Octree};

/// Is a hierarchy in a number, of any kind, as the core has it.
#[derive(Clone, Copy, Debug)]
pub enum Tree<S: 'static> {
    /// A tree of boxes.
    Bvh(Bvh<S>),
    /// A tree of planes.
    Kd(Kd<S>),
    /// A tree of cubes.
    Octree(Octree<S>),
    /// Equal cubes.
    Grid(Grid<S>),
    /// None: every thing is asked.
    None(Every),
}

impl<S: Scalar> Tree<S> {
    /// Answers the hierarchy as the core asks for it; it lives as long as the program.
    pub fn leak(self) -> &'static dyn Hierarchy<S> {
        match self {
            Self::Bvh(bvh) => Box::leak(Box::new(bvh)),
            Self::Kd(kd) => Box::leak(Box::new(kd)),
            Self::Octree(octree) => Box::leak(Box::new(octree)),
            Self::Grid(grid) => Box::leak(Box::new(grid)),
            Self::None(every) => Box::leak(Box::new(every)),
        }
    }

    /// Counts the bytes that it takes, what it borrows included.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Bvh(bvh) => size_of_val(bvh) + size_of_val(bvh.nodes) + size_of_val(bvh.items),
            Self::Kd(kd) => size_of_val(kd) + size_of_val(kd.nodes) + of_lists(&kd.lists),
            Self::Octree(octree) => {
                size_of_val(octree) + size_of_val(octree.branches) + of_lists(&octree.lists)
            }
            Self::Grid(grid) => size_of_val(grid) + size_of_val(grid.content) + of_lists(&grid.lists),
            Self::None(every) => size_of_val(every),
        }
    }
}

fn of_lists(lists: &Lists) -> usize {
    size_of_val(lists.starts) + size_of_val(lists.items)
}
