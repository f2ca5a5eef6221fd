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
    bytes.extend(mesh.normals.as_flattened().iter().map(|step| *step as u8));
    bytes.extend(mesh.triangles.iter().flat_map(|corners| words(corners)));
    bytes.extend(mesh.nodes.iter().flat_map(node));
    bytes
}

fn words(words: &[u16]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}
