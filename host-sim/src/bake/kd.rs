use super::Bounds;
use super::boxes::{Boxes, Steps, half_area};
use super::lists::Lists;
use crate::rounded::Rounded;
use scanray::accel::{self, KdNode};
use std::collections::VecDeque;

/// Is how many splits may lie on the way to a leaf: as many as the core remembers.
const DEPTH: usize = 32;

/// Is how many things a leaf holds without being cut, if there are nodes enough: below it the tree grows
/// several times larger, for things that lie in ever more leaves.
const LEAF: usize = 4;

/// Is what it costs to look at a split, where asking a thing costs 1.
const SPLIT_COST: f64 = 0.3;

/// Is the share of the cost that is left where a split cuts off empty space (I. Wald and V. Havran 2006).
const EMPTY_SHARE: f64 = 0.8;

/// Is a tree of planes, each where the surface heuristic says that rays ask least (J. MacDonald and K. Booth
/// 1990): at an edge of some thing's box.
#[derive(Clone, Debug)]
pub struct Kd {
    boxes: Boxes,
    /// The nodes as the core has them.
    pub nodes: Vec<KdNode>,
    lists: Lists,
}

/// Is a part of space that is still to be cut.
struct Part {
    bounds: Steps,
    things: Vec<u16>,
    depth: usize,
}

impl Kd {
    /// Builds the tree over things that lie in boxes, at most 65535.
    pub fn build(things: &[Bounds]) -> Self {
        // Where there are more nodes than a link can name, leaves are made larger and splits dearer.
        let sizes = (0..).map(|power| 1 << power);
        sizes.map(|size| Self::with_leaves(things, size)).find(|kd| kd.nodes.len() <= 65_535).unwrap()
    }

    /// Builds the tree with leaves so many times as large as they are best.
    fn with_leaves(things: &[Bounds], size: usize) -> Self {
        let boxes = Boxes::new(things);
        let mut kd = Self { nodes: vec![], lists: Lists::new(), boxes };
        if things.is_empty() {
            return kd;
        }
        let root = Part { bounds: kd.boxes.whole, things: kd.boxes.all(), depth: 0 };
        let mut parts = VecDeque::from([root]);
        while let Some(part) = parts.pop_front() {
            let may_be_cut = part.depth < DEPTH && part.things.len() > LEAF * size;
            let cost = SPLIT_COST * size as f64;
            let cut = if may_be_cut { best_cut(&part, &kd.boxes.each, cost) } else { None };
            let Some(Cut { axis, at, .. }) = cut else {
                let list = kd.lists.number(part.things);
                kd.nodes.push(KdNode::Leaf { list });
                continue;
            };
            // Parts wait in the order in which their nodes will be listed.
            let children = kd.nodes.len() + parts.len() + 1;
            kd.nodes.push(KdNode::Split { axis: axis as u8, at, children: children as u16 });
            parts.extend(part.cut(axis, at, &kd.boxes.each));
        }
        kd
    }

    /// Answers the tree in a number; its lists live as long as the program.
    pub fn leak<S: Rounded>(&self) -> accel::Kd<S> {
        accel::Kd {
            lattice: self.boxes.cube.lattice(),
            bounds: self.boxes.whole,
            nodes: self.nodes.clone().leak(),
            count: self.boxes.each.len() as u16,
            lists: self.lists.leak(),
        }
    }

    /// Counts the bytes that the tree takes in flash.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.nodes) + self.lists.bytes()
    }
}

impl Part {
    /// Answers the parts on both sides of a plane.
    fn cut(&self, axis: usize, at: u16, boxes: &[Steps]) -> [Self; 2] {
        let [mut low, mut high] = [self.bounds; 2];
        (low[1][axis], high[0][axis]) = (at, at);
        let side = |bounds, reaches: &dyn Fn(&Steps) -> bool| {
            let things = self.things.iter().copied().filter(|thing| reaches(&boxes[usize::from(*thing)]));
            Self { bounds, things: things.collect(), depth: self.depth + 1 }
        };
        [side(low, &|thing| thing[0][axis] < at), side(high, &|thing| thing[1][axis] > at)]
    }
}

/// Is a plane, and what asking both sides of it costs.
struct Cut {
    axis: usize,
    at: u16,
    cost: f64,
}

/// Answers the cheapest plane to cut a part at, if it pays.
fn best_cut(part: &Part, boxes: &[Steps], split_cost: f64) -> Option<Cut> {
    let whole = part.things.len() as f64;
    let cuts = (0..3).filter_map(|axis| best_on_axis(part, boxes, axis, split_cost));
    cuts.min_by(|a, b| a.cost.total_cmp(&b.cost)).filter(|cut| cut.cost < whole)
}

fn best_on_axis(part: &Part, boxes: &[Steps], axis: usize, split_cost: f64) -> Option<Cut> {
    let [lowest, highest] = [part.bounds[0][axis], part.bounds[1][axis]];
    let edges = |end: usize| {
        let mut edges: Vec<u16> =
            part.things.iter().map(|thing| boxes[usize::from(*thing)][end][axis]).collect();
        edges.sort_unstable();
        edges
    };
    let (lows, highs) = (edges(0), edges(1));
    let area = half_area(&part.bounds);
    let (mut left, mut ended) = (0, 0);
    let mut best: Option<Cut> = None;
    let mut places: Vec<u16> = lows.iter().chain(&highs).copied().collect();
    places.sort_unstable();
    places.dedup();
    for at in places.into_iter().filter(|at| lowest < *at && *at < highest) {
        left += lows[left..].iter().take_while(|low| **low < at).count();
        ended += highs[ended..].iter().take_while(|high| **high <= at).count();
        let right = highs.len() - ended;
        let [mut low, mut high] = [part.bounds; 2];
        (low[1][axis], high[0][axis]) = (at, at);
        let asked = (half_area(&low) * left as f64 + half_area(&high) * right as f64) / area;
        let share = if left == 0 || right == 0 { EMPTY_SHARE } else { 1.0 };
        let cost = share * (split_cost + asked);
        if best.as_ref().is_none_or(|best| cost < best.cost) {
            best = Some(Cut { axis, at, cost });
        }
    }
    best
}
