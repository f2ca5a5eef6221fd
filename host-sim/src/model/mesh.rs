//! The core's mesh of a piece, with its hierarchy.

use super::piece::{Packing, Piece};
use crate::bake::octahedron::fold;
use crate::bake::source::{Grown, Literal};
use crate::bake::{Accel, Bounds};
use crate::rounded::Rounded;
use crate::scene_file::value::point;
use scanray::aabb::Aabb;
use scanray::accel::Hierarchy;
use scanray::{Corners, Mesh, Normals};

/// Makes the mesh of a piece in a number, its triangles in the order that the hierarchy wants; it stays in
/// memory as long as the program runs.
pub fn grow<S: Literal>(piece: &Piece, packing: &Packing, accel: Accel) -> Grown<S> {
    let boxes: Vec<Bounds> =
        piece.triangles.iter().map(|triangle| Bounds::around(piece.corners(*triangle, packing))).collect();
    let built = accel.build(&boxes);
    let tree = built.tree_in_order();
    let triangles: &'static [[u16; 3]] = match built.order() {
        Some(order) => {
            order.iter().map(|place| piece.triangles[usize::from(*place)]).collect::<Vec<_>>().leak()
        }
        None => piece.triangles.clone().leak(),
    };
    let mesh = assemble(piece, packing, triangles, tree.leak(), &Bounds::of(boxes));
    Grown { mesh: Box::leak(Box::new(mesh)), tree }
}

/// Makes the mesh of a piece's corners in a number, with its triangles in the order that the hierarchy knows;
/// what it borrows stays in memory as long as the program runs.
pub fn assemble<S: Rounded>(
    piece: &Piece,
    packing: &Packing,
    triangles: &'static [[u16; 3]],
    hierarchy: &'static dyn Hierarchy<S>,
    bounds: &Bounds,
) -> Mesh<S> {
    let (corners, normals) = lists(piece, packing);
    let texture: Vec<[S; 2]> = piece.texture.iter().map(|texture| texture.map(S::round)).collect();
    Mesh::new(triangles, corners, normals, hierarchy).with_texture(texture.leak()).with_bounds(hull(bounds))
}

fn lists<S: Rounded>(piece: &Piece, packing: &Packing) -> (Corners<S>, Normals<S>) {
    match packing {
        Packing::Packed(grid) => {
            let steps: Vec<[u16; 3]> = piece.places.iter().map(|place| grid.steps(*place)).collect();
            let (low, sides) = (point(grid.low), point(grid.sides));
            let corners = Corners::Quantized { low, sides, steps: steps.leak() };
            let folded: Vec<[i16; 2]> = piece.normals.iter().map(|normal| fold(*normal)).collect();
            (corners, if folded.is_empty() { Normals::Flat } else { Normals::Octahedral(folded.leak()) })
        }
        Packing::Exact => {
            let rounded =
                |list: &[[f64; 3]]| &*list.iter().map(|place| point(*place)).collect::<Vec<_>>().leak();
            let normals = rounded(&piece.normals);
            let normals = if normals.is_empty() { Normals::Flat } else { Normals::Exact(normals) };
            (Corners::Exact(rounded(&piece.places)), normals)
        }
    }
}

/// Answers the box in a number, wider by what rounding may take: 8 steps of fixed point and 8 roundings of
/// `f32`.
fn hull<S: Rounded>(bounds: &Bounds) -> Aabb<S> {
    let margin = 2_f64.powi(-17) + bounds.largest() * 2_f64.powi(-20);
    let center = std::array::from_fn(|axis| bounds.middle(axis));
    Aabb { center: point(center), half: point(bounds.sides().map(|side| 0.5 * side + margin)) }
}
