//! What things of a scene borrow from flash: each is written once, under a name.

use super::grown::Grown;
use super::layout::Layout;
use super::literal::Literal;
use super::mesh;
use super::picture::{self, Kind};
use crate::bake::Bill;
use scanray::{Bitmap, Mesh, Vec3, Vertex};

/// Holds what has been borrowed so far.
#[derive(Debug)]
pub(super) struct Pool<'a, S: Literal> {
    /// The meshes that are known with their hierarchies.
    pub grown: &'a [Grown<S>],
    images: Vec<Bitmap>,
    outlines: Vec<&'static [Vec3<S>]>,
    facets: Vec<&'static [Vertex<S>; 3]>,
    meshes: Vec<Grown<S>>,
}

impl<'a, S: Literal> Pool<'a, S> {
    /// Makes an empty one.
    pub fn new(grown: &'a [Grown<S>]) -> Self {
        Self { grown, images: vec![], outlines: vec![], facets: vec![], meshes: vec![] }
    }

    /// Answers the expression that borrows an image.
    pub fn image(&mut self, bitmap: Bitmap) -> String {
        let known = self.images.iter().position(|image| *image == bitmap);
        let place = known.unwrap_or_else(|| {
            self.images.push(bitmap);
            self.images.len() - 1
        });
        format!("Bitmap::new(&IMAGE_{place})")
    }

    /// Answers the expression that borrows the corners of a polygon.
    pub fn outline(&mut self, corners: &'static [Vec3<S>]) -> String {
        self.outlines.push(corners);
        format!("&OUTLINE_{}", self.outlines.len() - 1)
    }

    /// Answers the expression that borrows the corners of a smooth triangle.
    pub fn facet(&mut self, corners: &'static [Vertex<S>; 3]) -> String {
        self.facets.push(corners);
        format!("&FACETS[{}]", self.facets.len() - 1)
    }

    /// Answers the expression that borrows a mesh; `None` for one whose hierarchy is not known.
    pub fn mesh(&mut self, mesh: &'static Mesh<S>) -> Option<String> {
        self.meshes.push(*self.grown.iter().find(|grown| std::ptr::eq(grown.mesh, mesh))?);
        Some(format!("&MESH_{}", self.meshes.len() - 1))
    }

    /// Writes all that has been borrowed, and puts its bytes on the bill.
    pub fn write(&self, layout: &mut Layout, bill: &mut Bill) {
        for (place, corners) in self.outlines.iter().enumerate() {
            bill.outlines += size_of_val(*corners);
            let rows = corners.iter().map(|corner| S::vector(*corner));
            layout.rows(&format!("OUTLINE_{place}"), &format!("Vec3<{}>", S::NAME), rows);
        }
        if !self.facets.is_empty() {
            bill.outlines += self.facets.len() * size_of::<[Vertex<S>; 3]>();
            let facets: Vec<String> = self.facets.iter().map(|corners| facet(corners)).collect();
            layout.list("FACETS", &format!("[Vertex<{}>; 3]", S::NAME), &facets);
        }
        for (place, grown) in self.meshes.iter().enumerate() {
            mesh::write(place, grown, layout, bill);
        }
        let kinds: Vec<Kind> = self.images.iter().map(Kind::of).collect();
        for (place, (bitmap, kind)) in self.images.iter().zip(&kinds).enumerate() {
            picture::write(place, bitmap, *kind, layout, bill);
        }
        if !kinds.is_empty() {
            picture::write_reader(layout);
        }
    }
}

fn facet<S: Literal>(corners: &[Vertex<S>; 3]) -> String {
    let corner = |vertex: &Vertex<S>| {
        let [u, v] = vertex.texture.map(S::number);
        format!("Vertex::new({}, {}, [{u}, {v}])", S::vector(vertex.point), S::vector(vertex.normal))
    };
    format!("[{}]", corners.each_ref().map(corner).join(", "))
}
