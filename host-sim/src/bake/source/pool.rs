//! What things of a scene borrow from flash: each is written once, under a name.

use super::grown::Grown;
use super::layout::Layout;
use super::literal::Literal;
use super::mesh;
use super::picture::{self, Kind};
use super::volume;
use crate::bake::Bill;
use scanray::{Bitmap, Grid, Mesh, Vec3, Vertex, Voxels};
use std::ptr;

/// Holds what has been borrowed so far.
#[derive(Debug)]
pub(super) struct Pool<'a, S: Literal> {
    /// The meshes that are known with their hierarchies.
    pub grown: &'a [Grown<S>],
    images: Vec<Bitmap>,
    outlines: Vec<&'static [Vec3<S>]>,
    facets: Vec<&'static [Vertex<S>; 3]>,
    meshes: Vec<Grown<S>>,
    /// Grids with their expressions.
    grids: Vec<(&'static Grid<S>, String)>,
    voxels: Vec<Voxels>,
}

impl<'a, S: Literal> Pool<'a, S> {
    /// Makes an empty one.
    pub fn new(grown: &'a [Grown<S>]) -> Self {
        let (images, outlines, facets) = (vec![], vec![], vec![]);
        Self { grown, images, outlines, facets, meshes: vec![], grids: vec![], voxels: vec![] }
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
        let is_it = |grown: &&Grown<S>| ptr::eq(grown.mesh, mesh);
        let place = match self.meshes.iter().position(|grown| is_it(&grown)) {
            Some(place) => place,
            None => {
                self.meshes.push(*self.grown.iter().find(is_it)?);
                self.meshes.len() - 1
            }
        };
        Some(format!("&MESH_{place}"))
    }

    /// Answers the expression that borrows a grid of voxels.
    pub fn grid(&mut self, grid: &'static Grid<S>) -> String {
        let known = self.grids.iter().position(|(known, _)| ptr::eq(*known, grid));
        let place = known.unwrap_or_else(|| {
            let text = volume::grid(grid, self);
            self.grids.push((grid, text));
            self.grids.len() - 1
        });
        format!("&GRID_{place}")
    }

    /// Answers the expression for voxels.
    pub fn voxels(&mut self, voxels: Voxels) -> String {
        let known = self.voxels.iter().position(|known| *known == voxels);
        let place = known.unwrap_or_else(|| {
            self.voxels.push(voxels);
            self.voxels.len() - 1
        });
        format!("VOXELS_{place}")
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
        for (place, (grid, text)) in self.grids.iter().enumerate() {
            bill.volumes += size_of_val(*grid);
            layout.item("", &format!("static GRID_{place}: Grid<{}> = {text}", S::NAME));
        }
        for (place, voxels) in self.voxels.iter().enumerate() {
            volume::write_voxels(place, voxels, layout, bill);
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
