use super::Bounds;
use super::boxes::{Boxes, Steps};
use super::lists::Lists;
use crate::rounded::Rounded;
use scanray::accel::{self, Octant};
use std::collections::VecDeque;

/// Is how many things a leaf may hold without being cut.
const LEAF: usize = 4;

/// Is how often the cube may be halved: parts are then 16 steps wide.
const LEVELS: u32 = 12;

/// Is a tree that cuts a cube into eight, and each part again as long as that leaves less to ask.
#[derive(Clone, Debug)]
pub struct Octree {
    boxes: Boxes,
    /// The branches as the core has them.
    pub branches: Vec<[Octant; 8]>,
    lists: Lists,
}

/// Is a part that is to be cut: its lowest corner, how often the cube was halved for it, and what it holds.
struct Part {
    corner: [u16; 3],
    level: u32,
    things: Vec<u16>,
}

impl Octree {
    /// Builds the tree over things that lie in boxes, at most 65535.
    pub fn build(things: &[Bounds]) -> Self {
        // Where there are more branches or lists than an octant can name, larger leaves leave fewer.
        let fits = |tree: &Self| tree.branches.len() <= 32_767 && tree.lists.len() <= 32_767;
        (0..).map(|power| Self::with_leaves(things, LEAF << power)).find(fits).unwrap()
    }

    fn with_leaves(things: &[Bounds], most: usize) -> Self {
        let boxes = Boxes::new(things);
        let mut tree = Self { branches: vec![], lists: Lists::new(), boxes };
        if things.is_empty() {
            return tree;
        }
        let mut parts = VecDeque::from([Part { corner: [0; 3], level: 0, things: tree.boxes.all() }]);
        while let Some(part) = parts.pop_front() {
            let octants = part.octants(&tree.boxes.each).map(|octant| {
                if octant.is_worth_cutting(&tree.boxes.each, most) {
                    parts.push_back(octant);
                    // Parts wait in the order in which their branches will be listed.
                    return Octant::branch((tree.branches.len() + parts.len()) as u16);
                }
                Octant::leaf(tree.lists.number(octant.things))
            });
            tree.branches.push(octants);
        }
        tree
    }

    /// Answers the tree in a number; its lists live as long as the program.
    pub fn leak<S: Rounded>(&self) -> accel::Octree<S> {
        accel::Octree {
            lattice: self.boxes.cube.lattice(),
            bounds: self.boxes.whole,
            branches: self.branches.clone().leak(),
            count: self.boxes.each.len() as u16,
            lists: self.lists.leak(),
        }
    }

    /// Counts the bytes that the tree takes in flash.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.branches) + self.lists.bytes()
    }
}

impl Part {
    fn octants(&self, boxes: &[Steps]) -> [Self; 8] {
        let half = 0x8000_u16 >> self.level;
        std::array::from_fn(|place| {
            let corner = [0, 1, 2].map(|axis| self.corner[axis] + half * (place as u16 >> axis & 1));
            let reaches = |thing: &u16| {
                let [low, high] = boxes[usize::from(*thing)];
                (0..3).all(|axis| {
                    let end = u32::from(corner[axis]) + u32::from(half);
                    u32::from(low[axis]) < end && high[axis] > corner[axis]
                })
            };
            let things = self.things.iter().copied().filter(reaches).collect();
            Self { corner, level: self.level + 1, things }
        })
    }

    /// Tells whether rays ask less where the part is cut: those that meet a cube meet each of its octants in
    /// one of four cases, by their surfaces.
    fn is_worth_cutting(&self, boxes: &[Steps], most: usize) -> bool {
        if self.things.len() <= most || self.level >= LEVELS {
            return false;
        }
        let asked: usize = self.octants(boxes).iter().map(|octant| octant.things.len()).sum();
        asked < 4 * self.things.len()
    }
}
