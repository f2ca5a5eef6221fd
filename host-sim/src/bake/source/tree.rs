//! Hierarchies in source. To add one: an arm, which the compiler asks for.

use super::layout::Layout;
use super::literal::Literal;
use crate::bake::Tree;
use scanray::accel::{Bvh, BvhNode, Content, Grid, Kd, KdNode, Lattice, Lists, Octant, Octree};

/// Writes a hierarchy as a static of this name.
pub(super) fn write<S: Literal>(tree: &Tree<S>, name: &str, layout: &mut Layout) {
    match tree {
        Tree::Bvh(bvh) => write_bvh(bvh, name, layout),
        Tree::Kd(kd) => write_kd(kd, name, layout),
        Tree::Octree(octree) => write_octree(octree, name, layout),
        Tree::Grid(grid) => write_grid(grid, name, layout),
        Tree::None(every) => {
            layout.item("", &format!("static {name}: accel::Every = accel::Every({})", every.0));
        }
    }
}

/// Writes the static itself: its kind, and its fields behind the lattice.
fn write_head<S: Literal>(
    [name, kind]: [&str; 2],
    lattice: &Lattice<S>,
    fields: &[(&str, String)],
    layout: &mut Layout,
) {
    let (low, side, number) = (S::vector(lattice.low), lattice.side.number(), S::NAME);
    let fields: String = fields.iter().map(|(field, value)| format!("    {field}: {value},\n")).collect();
    let item = format!(
        "static {name}: accel::{kind}<{number}> = accel::{kind} {{\n    \
         lattice: accel::Lattice::new(\n        {low},\n        {side},\n    ),\n{fields}}}"
    );
    layout.item("", &item);
}

fn write_bvh<S: Literal>(bvh: &Bvh<S>, name: &str, layout: &mut Layout) {
    let listed = if bvh.items.is_empty() { "&[]".to_owned() } else { format!("&{name}_ITEMS") };
    let fields = [("nodes", format!("&{name}_NODES")), ("count", bvh.count.to_string()), ("items", listed)];
    write_head([name, "Bvh"], &bvh.lattice, &fields, layout);
    layout.rows(&format!("{name}_NODES"), "accel::BvhNode", bvh.nodes.iter().map(bvh_node));
    if !bvh.items.is_empty() {
        layout.rows(&format!("{name}_ITEMS"), "u16", bvh.items.iter().map(u16::to_string));
    }
}

fn bvh_node(node: &BvhNode) -> String {
    let BvhNode { bounds: [low, high], link, parent, items, axis } = node;
    format!("accel::BvhNode::new([{low:?}, {high:?}], {link}, {parent}, {items}, {axis})")
}

fn write_kd<S: Literal>(kd: &Kd<S>, name: &str, layout: &mut Layout) {
    let fields = [
        ("bounds", format!("{:?}", kd.bounds)),
        ("nodes", format!("&{name}_NODES")),
        ("count", kd.count.to_string()),
        ("lists", lists(name)),
    ];
    write_head([name, "Kd"], &kd.lattice, &fields, layout);
    layout.rows(&format!("{name}_NODES"), "accel::KdNode", kd.nodes.iter().map(kd_node));
    write_lists(&kd.lists, name, layout);
}

fn kd_node(node: &KdNode) -> String {
    match node {
        KdNode::Split { axis, at, children } => {
            format!("accel::KdNode::Split {{ axis: {axis}, at: {at}, children: {children} }}")
        }
        KdNode::Leaf { list } => format!("accel::KdNode::Leaf {{ list: {list} }}"),
    }
}

fn write_octree<S: Literal>(octree: &Octree<S>, name: &str, layout: &mut Layout) {
    let fields = [
        ("bounds", format!("{:?}", octree.bounds)),
        ("branches", format!("&{name}_BRANCHES")),
        ("count", octree.count.to_string()),
        ("lists", lists(name)),
    ];
    write_head([name, "Octree"], &octree.lattice, &fields, layout);
    // The two halves along z: eight octants are wider than the page.
    let half = |octants: &[Octant]| octants.iter().map(octant).collect::<Vec<_>>().join(", ");
    let branch = |octants: &[Octant; 8]| {
        format!("        [{},\n         {}],\n", half(&octants[..4]), half(&octants[4..]))
    };
    let branches: String = octree.branches.iter().map(branch).collect();
    let item = format!(
        "static {name}_BRANCHES: [[accel::Octant; 8]; {}] = {{\n    use accel::Octant;\n    \
         [\n{branches}    ]\n}}",
        octree.branches.len()
    );
    layout.item("", &item);
    write_lists(&octree.lists, name, layout);
}

fn octant(octant: &Octant) -> String {
    match octant.content() {
        Content::Branch(branch) => format!("Octant::branch({branch})"),
        Content::List(list) => format!("Octant::leaf({list})"),
    }
}

fn write_grid<S: Literal>(grid: &Grid<S>, name: &str, layout: &mut Layout) {
    let fields = [
        ("low", format!("{:?}", grid.low)),
        ("size", grid.size.to_string()),
        ("cells", format!("{:?}", grid.cells)),
        ("content", format!("&{name}_CONTENT")),
        ("count", grid.count.to_string()),
        ("lists", lists(name)),
    ];
    write_head([name, "Grid"], &grid.lattice, &fields, layout);
    layout.rows(&format!("{name}_CONTENT"), "u16", grid.content.iter().map(u16::to_string));
    write_lists(&grid.lists, name, layout);
}

/// Answers the expression for the lists of a hierarchy.
fn lists(name: &str) -> String {
    format!("accel::Lists::new(&{name}_STARTS, &{name}_ITEMS)")
}

fn write_lists(lists: &Lists, name: &str, layout: &mut Layout) {
    layout.rows(&format!("{name}_STARTS"), "u32", lists.starts.iter().map(u32::to_string));
    layout.rows(&format!("{name}_ITEMS"), "u16", lists.items.iter().map(u16::to_string));
}
