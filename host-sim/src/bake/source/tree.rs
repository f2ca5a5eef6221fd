//! Hierarchies in source.

use super::layout::Layout;
use super::literal::Literal;
use scanray::accel::{Bvh, BvhNode, Every, Hierarchy};

/// Is a hierarchy that says itself how it is written.
pub trait Written<S: Literal>: Hierarchy<S> + std::fmt::Debug {
    /// Answers the hierarchy as the core asks for it.
    fn hierarchy(&'static self) -> &'static dyn Hierarchy<S>;

    /// Counts the bytes of its data.
    fn bytes(&self) -> usize;

    /// Writes it as a static of this name.
    fn write(&self, name: &str, layout: &mut Layout);
}

impl<S: Literal> Written<S> for Every {
    fn hierarchy(&'static self) -> &'static dyn Hierarchy<S> {
        self
    }

    fn bytes(&self) -> usize {
        size_of::<Self>()
    }

    fn write(&self, name: &str, layout: &mut Layout) {
        layout.item("", &format!("static {name}: accel::Every = accel::Every({})", self.0));
    }
}

impl<S: Literal> Written<S> for Bvh<S> {
    fn hierarchy(&'static self) -> &'static dyn Hierarchy<S> {
        self
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(self.nodes) + size_of_val(self.items)
    }

    fn write(&self, name: &str, layout: &mut Layout) {
        let Self { lattice, nodes, count, items } = self;
        let (low, side) = (S::vector(lattice.low), lattice.side.number());
        let listed = if items.is_empty() { "&[]".to_owned() } else { format!("&{name}_ITEMS") };
        let item = format!(
            "static {name}: accel::Bvh<{0}> = accel::Bvh {{\n    \
             lattice: accel::Lattice::new(\n        {low},\n        {side},\n    ),\n    \
             nodes: &{name}_NODES,\n    count: {count},\n    items: {listed},\n}}",
            S::NAME
        );
        layout.item("", &item);
        layout.rows(&format!("{name}_NODES"), "accel::BvhNode", nodes.iter().map(node));
        if !items.is_empty() {
            layout.rows(&format!("{name}_ITEMS"), "u16", items.iter().map(u16::to_string));
        }
    }
}

fn node(node: &BvhNode) -> String {
    let BvhNode { bounds: [low, high], link, parent, items, axis } = node;
    format!("accel::BvhNode::new([{low:?}, {high:?}], {link}, {parent}, {items}, {axis})")
}
