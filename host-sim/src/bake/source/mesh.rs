//! Meshes in source: triangles, corners, normals and texture coordinates as rows of data.

use super::grown::Grown;
use super::layout::Layout;
use super::literal::Literal;
use super::tree;
use crate::bake::Bill;
use scanray::{Corners, Mesh, Normals};

/// Writes a mesh and all that it borrows.
pub(super) fn write<S: Literal>(place: usize, grown: &Grown<S>, layout: &mut Layout, bill: &mut Bill) {
    let mesh = grown.mesh;
    put_on(bill, grown);
    let [corners, normals] = [corners(place, mesh), normals(place, mesh)];
    let mut item = format!(
        "static MESH_{place}: Mesh<{}> = Mesh::new(&TRIANGLES_{place}, {corners}, {normals}, &TREE_{place})",
        S::NAME
    );
    if !mesh.texture.is_empty() {
        item += &format!("\n    .with_texture(&TEXTURE_{place})");
    }
    if let Some(bounds) = mesh.bounds {
        let [center, half] = [bounds.center, bounds.half].map(S::vector);
        item += &format!(
            "\n    .with_bounds(aabb::Aabb {{\n        center: {center},\n        half: {half},\n    }})"
        );
    }
    layout.item("", &item);
    let triples = |list: &'static [[u16; 3]]| list.iter().map(|triple| format!("{triple:?}"));
    layout.rows(&format!("TRIANGLES_{place}"), "[u16; 3]", triples(mesh.triangles));
    match mesh.corners {
        Corners::Exact(places) => {
            let rows = places.iter().map(|place| S::vector(*place));
            layout.rows(&format!("CORNERS_{place}"), &format!("Vec3<{}>", S::NAME), rows);
        }
        Corners::Quantized { steps, .. } => {
            layout.rows(&format!("CORNERS_{place}"), "[u16; 3]", triples(steps));
        }
    }
    match mesh.normals {
        Normals::Flat => {}
        Normals::Exact(normals) => {
            let rows = normals.iter().map(|normal| S::vector(*normal));
            layout.rows(&format!("NORMALS_{place}"), &format!("Vec3<{}>", S::NAME), rows);
        }
        Normals::Octahedral(points) => {
            let rows = points.iter().map(|point| format!("{point:?}"));
            layout.rows(&format!("NORMALS_{place}"), "[i16; 2]", rows);
        }
    }
    if !mesh.texture.is_empty() {
        let rows = mesh.texture.iter().map(|[u, v]| format!("[{}, {}]", u.number(), v.number()));
        layout.rows(&format!("TEXTURE_{place}"), &format!("[{}; 2]", S::NAME), rows);
    }
    tree::write(&grown.tree, &format!("TREE_{place}"), layout);
}

fn corners<S: Literal>(place: usize, mesh: &Mesh<S>) -> String {
    match &mesh.corners {
        Corners::Exact(_) => format!("Corners::Exact(&CORNERS_{place})"),
        Corners::Quantized { low, sides, .. } => {
            let [low, sides] = [*low, *sides].map(S::vector);
            format!(
                "Corners::Quantized {{\n    low: {low},\n    sides: {sides},\n    steps: &CORNERS_{place},\n}}"
            )
        }
    }
}

fn normals<S: Literal>(place: usize, mesh: &Mesh<S>) -> String {
    match &mesh.normals {
        Normals::Flat => "Normals::Flat".to_owned(),
        Normals::Exact(_) => format!("Normals::Exact(&NORMALS_{place})"),
        Normals::Octahedral(_) => format!("Normals::Octahedral(&NORMALS_{place})"),
    }
}

fn put_on<S: Literal>(bill: &mut Bill, grown: &Grown<S>) {
    let mesh = grown.mesh;
    bill.meshes += size_of_val(mesh);
    bill.triangles += size_of_val(mesh.triangles);
    bill.corners += match mesh.corners {
        Corners::Exact(places) => size_of_val(places),
        Corners::Quantized { steps, .. } => size_of_val(steps),
    } + size_of_val(mesh.texture);
    bill.normals += match mesh.normals {
        Normals::Flat => 0,
        Normals::Exact(normals) => size_of_val(normals),
        Normals::Octahedral(points) => size_of_val(points),
    };
    bill.hierarchies += grown.tree.bytes();
    bill.triangle_count += mesh.triangles.len();
    bill.corner_count += mesh.corners.len();
}
