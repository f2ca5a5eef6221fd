/// Follows a tree whose nodes are listed breadth first, each one's children together: node by node it proves
/// that each but the root is the child of one before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct BreadthFirst {
    /// How many nodes have been listed or named as children.
    named: usize,
    /// The number at which the next level begins.
    next_level: usize,
    /// How many levels lie above the node.
    pub depth: u8,
}

impl BreadthFirst {
    /// Begins before the root.
    pub const fn new() -> Self {
        Self { named: 1, next_level: 1, depth: 0 }
    }

    /// Goes to a node; tells whether it is the root or was named by one before it.
    pub fn goes_to(&mut self, node: usize) -> bool {
        if node == self.next_level {
            self.depth = self.depth.saturating_add(1);
            self.next_level = self.named;
        }
        node < self.named
    }

    /// Takes note of children; tells whether they are the next in the list.
    pub fn names(&mut self, first: u16, count: usize) -> bool {
        let next = usize::from(first) == self.named;
        self.named = self.named.saturating_add(count);
        next
    }

    /// Tells whether the list ends after the last child.
    pub fn ends_at(&self, nodes: usize) -> bool {
        nodes == 0 || nodes == self.named
    }
}
