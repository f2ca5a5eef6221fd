use super::{Bounds, Cube};
use crate::rounded::Rounded;
use scanray::accel::{self, BvhNode};

/// Is into how many slices a box is cut to look for the best place to split it.
const SLICES: usize = 16;

/// Is how many things a leaf has at most, if there are nodes enough.
const LEAF: usize = 4;

/// Is what it costs to ask a box, where asking a thing costs 1: more than it takes in time, for a box takes
/// flash too.
const BOX_COST: f64 = 1.5;

/// Is a tree of boxes, split where the surface heuristic says that rays ask least (J. Goldsmith and J. Salmon
/// 1987; slices of I. Wald 2007).
#[derive(Clone, Debug)]
pub struct Bvh {
    cube: Cube,
    /// The nodes as the core has them.
    pub nodes: Vec<BvhNode>,
    /// The things in the order of the leaves.
    pub order: Vec<u16>,
}

/// Is a node whose things are still to be split: its number, its parent's and its part of the order.
struct Task {
    number: usize,
    parent: usize,
    first: usize,
    end: usize,
}

impl Bvh {
    /// Builds the tree over things that lie in boxes, at most 65535.
    pub fn build(things: &[Bounds]) -> Self {
        // Where there are more nodes than a link can name, leaves are made larger and boxes dearer.
        (1..).map(|size| Self::with_leaves(things, size)).find(|bvh| bvh.nodes.len() <= 65_535).unwrap()
    }

    /// Builds the tree with leaves so many times as large as they are best.
    fn with_leaves(things: &[Bounds], size: usize) -> Self {
        let cube = Cube::around(&Bounds::of(things.iter().copied()));
        let mut bvh = Self { cube, nodes: vec![], order: (0..things.len() as u16).collect() };
        if things.is_empty() {
            return bvh;
        }
        let leaf = BvhNode::new([[0; 3]; 2], 0, 0, 0, 0);
        bvh.nodes.push(leaf);
        let mut tasks = vec![Task { number: 0, parent: 0, first: 0, end: things.len() }];
        while let Some(Task { number, parent, first, end }) = tasks.pop() {
            let part = &mut bvh.order[first..end];
            let bounds = Bounds::of(part.iter().map(|thing| things[usize::from(*thing)]));
            let split = split(part, things, &bounds, size);
            let node = &mut bvh.nodes[number];
            *node = BvhNode { bounds: cube.steps(&bounds), parent: parent as u16, ..leaf };
            let Some((axis, left)) = split else {
                (node.link, node.items) = (first as u16, (end - first) as u8);
                continue;
            };
            let child = bvh.nodes.len();
            let node = &mut bvh.nodes[number];
            (node.link, node.axis) = (child as u16, axis as u8);
            bvh.nodes.extend([leaf; 2]);
            tasks.push(Task { number: child + 1, parent: number, first: first + left, end });
            tasks.push(Task { number: child, parent: number, first, end: first + left });
        }
        bvh
    }

    /// Answers the tree in a number, for things in their own order; the lists live as long as the program.
    pub fn leak<S: Rounded>(&self) -> accel::Bvh<S> {
        let in_order = self.leak_in_order();
        // Things that already lie in the order of the leaves need no list.
        if self.order.is_sorted() {
            in_order
        } else {
            accel::Bvh { items: self.order.clone().leak(), ..in_order }
        }
    }

    /// Answers the tree in a number, for things that are listed in [`Self::order`].
    pub fn leak_in_order<S: Rounded>(&self) -> accel::Bvh<S> {
        accel::Bvh {
            lattice: self.cube.lattice(),
            nodes: self.nodes.clone().leak(),
            count: self.order.len() as u16,
            items: &[],
        }
    }

    /// Answers the cube that its boxes are told in.
    pub fn lattice<S: Rounded>(&self) -> accel::Lattice<S> {
        self.cube.lattice()
    }

    /// Counts the bytes that the tree takes in flash, of things listed in its order.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.nodes)
    }
}

/// Sorts the things of a node into two children and answers the axis along which these lie side by side and
/// how many the first has; `None` for a leaf.
fn split(part: &mut [u16], things: &[Bounds], bounds: &Bounds, size: usize) -> Option<(usize, usize)> {
    let (most, box_cost) = (LEAF * size, BOX_COST * size as f64);
    if part.len() < 2 {
        return None;
    }
    let middle = |thing: u16, axis: usize| things[usize::from(thing)].middle(axis);
    let best =
        (0..3).filter_map(|axis| best_slice(part, things, axis)).min_by(|a, b| a.cost.total_cmp(&b.cost));
    let leaf_cost = bounds.half_area() * part.len() as f64;
    match best {
        Some(best) if part.len() > most || best.cost + box_cost * bounds.half_area() < leaf_cost => {
            part.sort_by(|a, b| middle(*a, best.axis).total_cmp(&middle(*b, best.axis)));
            let left = part.partition_point(|thing| middle(*thing, best.axis) < best.place);
            Some((best.axis, left))
        }
        // All middles in one place: halves are as good as any.
        None if part.len() > most => Some((0, part.len() / 2)),
        _ => None,
    }
}

/// Is a place to split at, and what asking both sides costs.
struct Slice {
    axis: usize,
    place: f64,
    cost: f64,
}

fn best_slice(part: &[u16], things: &[Bounds], axis: usize) -> Option<Slice> {
    let boxes = || part.iter().map(|thing| &things[usize::from(*thing)]);
    let low = boxes().map(|bounds| bounds.middle(axis)).fold(f64::INFINITY, f64::min);
    let high = boxes().map(|bounds| bounds.middle(axis)).fold(f64::NEG_INFINITY, f64::max);
    let places = (1..SLICES).map(|slice| low + (high - low) * slice as f64 / SLICES as f64);
    let slices = places.filter(|place| low < *place).map(|place| {
        let (mut sides, mut counts) = ([Bounds::NOTHING; 2], [0_usize; 2]);
        for bounds in boxes() {
            let side = usize::from(bounds.middle(axis) >= place);
            sides[side] = sides[side].and(*bounds);
            counts[side] += 1;
        }
        let cost = sides.iter().zip(counts).map(|(side, count)| side.half_area() * count as f64).sum();
        Slice { axis, place, cost }
    });
    slices.min_by(|a, b| a.cost.total_cmp(&b.cost))
}
