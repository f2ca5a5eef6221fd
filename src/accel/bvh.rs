use super::lattice::{Lattice, Steps};
use super::slabs::Slabs;
use super::{Hierarchy, Visit};
use crate::fault::Fault;
use crate::math::Scalar;
use crate::ray::{Interval, Ray};

/// Is a tree of boxes, each around those of its two children (row K1; S. Rubin and T. Whitted 1980).
///
/// It is walked without a stack, from parent to near child to far child and back up (M. Hapala et al. 2011,
/// "Efficient Stack-less BVH Traversal for Ray Tracing"): no tree is too deep, and each box is asked at most
/// once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bvh<S: 'static = f32> {
    /// The cube that boxes are told in.
    pub lattice: Lattice<S>,
    /// The root, then pairs of siblings: never more than 65535.
    pub nodes: &'static [BvhNode],
    /// How many things the leaves name together.
    pub count: u16,
    /// What leaves name, leaf by leaf; empty where things are numbered in the order of the leaves.
    pub items: &'static [u16],
}

/// Is a box with its place in the tree, in 18 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BvhNode {
    /// Lowest and highest corner, in steps of the lattice.
    pub bounds: [[u16; 3]; 2],
    /// Number of the first of two children, the one at lower coordinates; of a leaf, of its first item.
    pub link: u16,
    /// Number of the parent; the root's own, 0.
    pub parent: u16,
    /// How many items a leaf has; 0 for what has children.
    pub items: u8,
    /// Along which axis the children lie side by side: 0 to 2.
    pub axis: u8,
}

impl BvhNode {
    /// Makes a node; see the fields.
    pub const fn new(bounds: Steps, link: u16, parent: u16, items: u8, axis: u8) -> Self {
        Self { bounds, link, parent, items, axis }
    }

    fn is_leaf(&self) -> bool {
        self.items > 0
    }

    /// Answers the child that a ray comes to first.
    fn near_child(&self, slabs: &Slabs) -> u16 {
        self.link.saturating_add(u16::from(slabs.descends(usize::from(self.axis))))
    }
}

/// Siblings are 1 and 2, 3 and 4 ...
fn sibling(node: u16) -> u16 {
    (node.wrapping_sub(1) ^ 1).wrapping_add(1)
}

/// Tells where a walk comes from.
#[derive(Clone, Copy, PartialEq, Eq)]
enum From {
    Parent,
    Sibling,
    Child,
}

impl<S: Scalar> Bvh<S> {
    /// Names the items of a leaf; answers how far the ray still looks.
    fn visit_leaf(&self, leaf: &BvhNode, mut far: S, near: S, visit: Visit<'_, S>) -> S {
        for place in leaf.link..leaf.link.saturating_add(u16::from(leaf.items)) {
            far = visit(self.items.get(usize::from(place)).copied().unwrap_or(place));
            if far <= near {
                break;
            }
        }
        far
    }

    /// Tells whether an inner node is the parent of the two nodes that it links to, which come after it.
    fn has_its_children(&self, number: u16, node: &BvhNode) -> bool {
        let child = |at: u16| self.nodes.get(usize::from(at));
        let first = node.link;
        first > number
            && first % 2 == 1
            && child(first).is_some_and(|node| node.parent == number)
            && first.checked_add(1).and_then(child).is_some_and(|node| node.parent == number)
    }

    fn has_its_items(&self, leaf: &BvhNode) -> bool {
        let (first, count) = (usize::from(leaf.link), usize::from(leaf.items));
        if self.items.is_empty() {
            return first + count <= usize::from(self.count);
        }
        let items = self.items.get(first..first + count);
        items.is_some_and(|items| items.iter().all(|item| *item < self.count))
    }
}

impl<S: Scalar> Hierarchy<S> for Bvh<S> {
    fn walk(&self, ray: &Ray<S>, interval: &Interval<S>, visit: Visit<'_, S>) {
        let Some(entry) = self.lattice.enter(ray, interval) else { return };
        let (mut slabs, mut far) = (Slabs::new(&entry, entry.far), interval.far);
        let (mut at, mut from) = (0_u16, From::Parent);
        while let Some(node) = self.nodes.get(usize::from(at)) {
            if from != From::Child && slabs.meets(&node.bounds) {
                if !node.is_leaf() {
                    (at, from) = (node.near_child(&slabs), From::Parent);
                    continue;
                }
                let nearer = self.visit_leaf(node, far, interval.near, visit);
                if nearer <= interval.near {
                    return;
                }
                if nearer != far {
                    far = nearer;
                    slabs.look_up_to(&entry, far);
                }
            }
            if at == 0 {
                return;
            }
            let first = from == From::Parent
                || from == From::Child
                    && self.nodes.get(usize::from(node.parent)).map(|parent| parent.near_child(&slabs))
                        == Some(at);
            (at, from) = if first { (sibling(at), From::Sibling) } else { (node.parent, From::Child) };
        }
    }

    fn count(&self) -> u16 {
        self.count
    }

    fn check(&self) -> Result<(), Fault> {
        let whole = self.nodes.len() <= usize::from(u16::MAX) && self.lattice.is_in_range();
        let linked = self.nodes.iter().zip(0..u16::MAX).all(|(node, number)| {
            if node.is_leaf() { self.has_its_items(node) } else { self.has_its_children(number, node) }
        });
        if whole && linked { Ok(()) } else { Err(Fault::Hierarchy) }
    }
}
