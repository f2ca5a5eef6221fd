//! Hierarchies: sound ones over some boxes, and such whose links lead anywhere.

use super::values::Values;
use host_sim::bake::{Accel, Bounds};
use host_sim::rounded::Rounded;
use scanray::accel::{Bvh, BvhNode, Every, Grid, Hierarchy, Kd, KdNode, Lattice, Lists, Octant, Octree};

/// Answers a hierarchy over so many boxes that holds them, of any kind.
pub fn sound<S: Rounded>(values: &mut Values<S>, boxes: &[Bounds]) -> &'static dyn Hierarchy<S> {
    values.dice.pick(&Accel::ALL).build(boxes).leak()
}

/// Answers a small number, rarely a large one.
fn link<S: Rounded>(values: &mut Values<S>) -> u16 {
    if values.dice.one_in(12) { values.dice.bits() as u16 } else { values.dice.below(5) as u16 }
}

fn many<S: Rounded, T>(values: &mut Values<S>, one: fn(&mut Values<S>) -> T) -> &'static [T] {
    let count = values.dice.below(6);
    (0..count).map(|_| one(values)).collect::<Vec<_>>().leak()
}

fn steps<S: Rounded>(values: &mut Values<S>) -> [[u16; 3]; 2] {
    let corner = |values: &mut Values<S>| [0; 3].map(|_: u16| values.dice.bits() as u16);
    if values.dice.one_in(3) { [corner(values), corner(values)] } else { [[0; 3], [u16::MAX; 3]] }
}

fn lists<S: Rounded>(values: &mut Values<S>) -> Lists {
    let count = values.dice.below(5) as u32;
    let mut starts: Vec<u32> = (0..=count).collect();
    if values.dice.one_in(4) {
        starts.push(link(values).into());
    }
    Lists::new(starts.leak(), many(values, link))
}

fn node<S: Rounded>(values: &mut Values<S>) -> BvhNode {
    let items = values.dice.pick(&[0, 0, 1, 2, 255]);
    BvhNode::new(steps(values), link(values), link(values), items, values.dice.below(4) as u8)
}

fn split<S: Rounded>(values: &mut Values<S>) -> KdNode {
    if values.dice.one_in(2) {
        return KdNode::Leaf { list: link(values) };
    }
    let (axis, at) = (values.dice.below(4) as u8, values.dice.bits() as u16);
    KdNode::Split { axis, at, children: link(values) }
}

fn octant<S: Rounded>(values: &mut Values<S>) -> Octant {
    if values.dice.one_in(5) { Octant::branch(link(values)) } else { Octant::leaf(link(values)) }
}

/// Answers a hierarchy that is most likely none.
pub fn astray<S: Rounded>(values: &mut Values<S>) -> &'static dyn Hierarchy<S> {
    let lattice = Lattice::new(values.point(), values.radius());
    let (bounds, lists, count) = (steps(values), lists(values), link(values));
    match values.dice.below(5) {
        0 => {
            let (nodes, items) = (many(values, node), many(values, link));
            Box::leak(Box::new(Bvh { lattice, nodes, count, items }))
        }
        1 => Box::leak(Box::new(Kd { lattice, bounds, nodes: many(values, split), count, lists })),
        2 => {
            let cells = [link(values), link(values), link(values)];
            let (size, content) = (values.dice.bits() as u16, many(values, link));
            Box::leak(Box::new(Grid { lattice, low: bounds[0], size, cells, content, count, lists }))
        }
        3 => {
            let branches = many(values, |values| [0; 8].map(|_| octant(values)));
            Box::leak(Box::new(Octree { lattice, bounds, branches, count, lists }))
        }
        _ => Box::leak(Box::new(Every(count))),
    }
}
