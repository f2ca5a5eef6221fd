use super::literal::Literal;
use crate::bake::Tree;
use scanray::Mesh;

/// Is a mesh with the hierarchy that it borrows, which says itself how it is written.
#[derive(Clone, Copy, Debug)]
pub struct Grown<S: Literal> {
    /// The mesh.
    pub mesh: &'static Mesh<S>,
    /// Its hierarchy.
    pub tree: Tree<S>,
}
