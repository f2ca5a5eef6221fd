//! Hierarchies: which of many things a ray may meet, found without asking each (rows K1 to K3).
//!
//! A hierarchy knows boxes and rays, never shapes. It is made on a desktop and lies in flash; here it is only
//! walked, in constant RAM. It names every thing that a ray meets inside an interval, nearly in the order of
//! distance, and some that the ray does not meet: the shapes' own tests decide, so that pictures are those
//! of asking everything, to the bit.

mod breadth_first;
mod bvh;
mod every;
mod grid;
mod kd;
mod lattice;
mod lists;
mod octree;
mod slabs;

pub use bvh::{Bvh, BvhNode};
pub use every::Every;
pub use grid::Grid;
pub use kd::{Kd, KdNode};
pub use lattice::Lattice;
pub use lists::Lists;
pub use octree::{Content, Octant, Octree};

use crate::fault::Fault;
use crate::math::Scalar;
use crate::ray::{Interval, Ray};
use core::fmt;

/// Is told the number of a thing that the ray may meet, and answers how far the ray still looks: up to the
/// nearest crossing so far, or 0 to end the walk.
pub type Visit<'v, S> = &'v mut dyn FnMut(u16) -> S;

/// Is what a hierarchy must be able to do.
///
/// It is used as `&'static dyn Hierarchy`: an image carries the code of those kinds that its data name.
pub trait Hierarchy<S: Scalar>: Sync {
    /// Names all things that a ray meets inside the interval, and perhaps others and some twice.
    ///
    /// The interval's far end moves nearer as `visit` answers.
    fn walk(&self, ray: &Ray<S>, interval: &Interval<S>, visit: Visit<'_, S>);

    /// Answers how many things it holds: those numbered from 0.
    fn count(&self) -> u16;

    /// Tells whether its links lead everywhere once and nowhere else, so that every walk ends, and whether it
    /// names no thing but those that it holds.
    ///
    /// # Errors
    /// [`Fault::Hierarchy`].
    fn check(&self) -> Result<(), Fault>;
}

/// As a supertrait it would put what formats every number into each image with a hierarchy, used or not.
impl<S> fmt::Debug for dyn Hierarchy<S> + '_ {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Hierarchy")
    }
}
