//! The meshes of the gallery, computed: `cargo run -p host-sim --example meshes` writes them.
//!
//! The core includes the files as they are; a test tells whether they are what is computed here.

mod bezier;
mod knot;
mod teapot;

use crate::bake::Packed;

/// Is the name of a file of `src/gallery/meshes`, and its bytes.
pub type File = (&'static str, Vec<u8>);

/// Computes all meshes.
pub fn all() -> Vec<File> {
    vec![("teapot.mesh", bytes(&teapot::teapot().pack())), ("knot.mesh", bytes(&knot::knot().pack()))]
}

/// Writes a mesh: how many corners, triangles and nodes; lowest corner and sides of its box, lowest corner and
/// side of its lattice; corners, normals, triangles and nodes. Everything is little-endian.
fn bytes(mesh: &Packed) -> Vec<u8> {
    let counts = [mesh.steps.len(), mesh.triangles.len(), mesh.nodes.len()];
    let measures =
        [&mesh.bounds.low[..], &mesh.bounds.sides(), &mesh.lattice_low, &[mesh.lattice_side]].concat();
    let node = |node: &scanray::accel::BvhNode| {
        let [low, high] = node.bounds;
        let [link, parent] = [node.link, node.parent];
        [&words(&low)[..], &words(&high), &words(&[link, parent]), &[node.items, node.axis]].concat()
    };
    let mut bytes: Vec<u8> = counts.iter().flat_map(|count| (*count as u32).to_le_bytes()).collect();
    bytes.extend(measures.iter().flat_map(|value| value.to_le_bytes()));
    bytes.extend(mesh.steps.iter().flat_map(|steps| words(steps)));
    bytes.extend(mesh.normals.as_flattened().iter().flat_map(|step| step.to_le_bytes()));
    bytes.extend(mesh.triangles.iter().flat_map(|corners| words(corners)));
    bytes.extend(mesh.nodes.iter().flat_map(node));
    bytes
}

fn words(words: &[u16]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bake::Indexed;

    type Vector = [f64; 3];

    fn dot(a: Vector, b: Vector) -> f64 {
        (0..3).map(|axis| a[axis] * b[axis]).sum()
    }

    /// Answers the normal of a triangle, of any length.
    fn across(mesh: &Indexed, triangle: &[u16; 3]) -> Vector {
        let [a, b, c] = triangle.map(|corner| mesh.places[usize::from(corner)]);
        let edge = |to: Vector, axis: usize| to[axis] - a[axis];
        std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            edge(b, j) * edge(c, k) - edge(b, k) * edge(c, j)
        })
    }

    #[test]
    fn normals_look_to_the_outward_side_of_their_triangles() {
        // The lip of the spout turns in more sharply than its triangles do.
        for (mesh, turned) in [(teapot::teapot(), 4), (knot::knot(), 0)] {
            let outward = |triangle: &&[u16; 3]| {
                let flat = across(&mesh, triangle);
                triangle.iter().all(|corner| dot(mesh.normals[usize::from(*corner)], flat) > 0.0)
            };
            assert_eq!(mesh.triangles.iter().filter(outward).count(), mesh.triangles.len() - turned);
        }
    }

    /// The volume inside is a sum over the triangles, each with the origin, and above 0 if they look outward
    /// (the theorem of Gauss).
    #[test]
    fn the_meshes_are_seen_from_outside() {
        for mesh in [teapot::teapot(), knot::knot()] {
            let sixths =
                |triangle: &[u16; 3]| dot(mesh.places[usize::from(triangle[0])], across(&mesh, triangle));
            let volume = mesh.triangles.iter().map(sixths).sum::<f64>() / 6.0;
            assert!(volume > 10.0, "{volume}");
        }
    }
}
