use super::breadth_first::BreadthFirst;
use super::lattice::{Lattice, Passage};
use super::lists::Lists;
use super::{Hierarchy, Visit};
use crate::fault::Fault;
use crate::math::Scalar;
use crate::ray::{Interval, Ray};
use heapless::Vec;

/// Is how many splits lie on the way to any leaf, at most: the walk remembers one place for each, 256 bytes
/// in 32-bit numbers.
const DEPTH: usize = 32;

/// Is a tree that cuts space in two by planes across the axes, and each part again (row K3; J. Bentley 1975).
///
/// A ray goes through the parts in the order in which it meets them, and remembers the farther one of each
/// split (V. Havran 2000, "Heuristic Ray Shooting Algorithms": the recursive walk with a stack). The parts it
/// goes through fit together without a gap, whatever is rounded: each ends at the very number at which the
/// next begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kd<S: 'static = f32> {
    /// The cube that the tree is told in.
    pub lattice: Lattice<S>,
    /// The box around all things, in steps of the lattice.
    pub bounds: [[u16; 3]; 2],
    /// The root, then pairs of siblings level by level, in the order of their parents: never more than 65535.
    pub nodes: &'static [KdNode],
    /// How many things the lists name together.
    pub count: u16,
    /// What leaves hold.
    pub lists: Lists,
}

/// Is a split or a leaf, in 6 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KdNode {
    /// A plane.
    Split {
        /// The axis it goes across: 0 to 2.
        axis: u8,
        /// Where it does, in steps of the lattice.
        at: u16,
        /// Number of the child at lower coordinates; the other follows.
        children: u16,
    },
    /// A part of space with what reaches into it.
    Leaf {
        /// Number of its list.
        list: u16,
    },
}

/// Is a part of space that a ray comes to later.
#[derive(Clone, Copy, Debug)]
struct Later<S> {
    node: u16,
    /// The distance at which it does.
    near: S,
}

impl<S: Scalar> Hierarchy<S> for Kd<S> {
    fn walk(&self, ray: &Ray<S>, interval: &Interval<S>, visit: Visit<'_, S>) {
        let Some(entry) = self.lattice.enter(ray, interval) else { return };
        let mut passage = Passage::new(entry);
        let Some((mut near, end)) = passage.span(&self.bounds) else { return };
        let mut later: Vec<Later<S>, DEPTH> = Vec::new();
        let mut at = 0;
        while let Some(node) = self.nodes.get(usize::from(at)) {
            match *node {
                KdNode::Split { axis, at: step, children } => {
                    let axis = usize::from(axis);
                    // The part of this node ends where the next one begins.
                    let far = later.last().map_or(end, |part| part.near);
                    let plane = passage.reach(axis, step);
                    let descends = u16::from(passage.descends(axis));
                    let (first, second) =
                        (children.saturating_add(descends), children.saturating_add(1 ^ descends));
                    if plane < near {
                        at = second;
                        continue;
                    }
                    // No tree that is checked is deeper than the places that there are.
                    if plane <= far && later.push(Later { node: second, near: plane }).is_err() {
                        return;
                    }
                    at = first;
                }
                KdNode::Leaf { list } => {
                    if !self.lists.visit(list, &mut passage, interval.near, visit) {
                        return;
                    }
                    let Some(part) = later.pop().filter(|part| part.near <= passage.far()) else { return };
                    (at, near) = (part.node, part.near);
                }
            }
        }
    }

    fn count(&self) -> u16 {
        self.count
    }

    fn check(&self) -> Result<(), Fault> {
        let mut tree = BreadthFirst::new();
        let linked = (0..self.nodes.len()).zip(self.nodes).all(|(number, node)| {
            tree.goes_to(number)
                && match *node {
                    KdNode::Split { axis, children, .. } => {
                        axis < 3 && usize::from(tree.depth) < DEPTH && tree.names(children, 2)
                    }
                    KdNode::Leaf { list } => self.lists.has(list),
                }
        });
        let whole = self.nodes.len() <= usize::from(u16::MAX) && tree.ends_at(self.nodes.len());
        if linked && whole && self.lattice.is_in_range() && self.lists.are_sound(self.count) {
            Ok(())
        } else {
            Err(Fault::Hierarchy)
        }
    }
}
