//! The meshes of the gallery, in flash. `cargo run -p host-sim --example meshes` computes them.

use crate::accel::BvhNode;

/// Is what of a mesh is the same in every number; `C` corners, `T` triangles, `N` nodes of its tree.
pub(super) struct Packed<const C: usize, const T: usize, const N: usize> {
    /// Lowest corner and sides of the box of the corners; lowest corner and side of the tree's lattice.
    pub measures: [f64; 10],
    pub steps: [[u16; 3]; C],
    pub normals: [[i8; 2]; C],
    pub triangles: [[u16; 3]; T],
    pub nodes: [BvhNode; N],
}

const fn word(bytes: &[u8], at: usize) -> u16 {
    u16::from_le_bytes([bytes[at], bytes[at + 1]])
}

const fn triple(bytes: &[u8], at: usize) -> [u16; 3] {
    [word(bytes, at), word(bytes, at + 2), word(bytes, at + 4)]
}

const fn triples<const COUNT: usize>(bytes: &[u8], at: usize) -> [[u16; 3]; COUNT] {
    let mut triples = [[0; 3]; COUNT];
    let mut i = 0;
    while i < COUNT {
        triples[i] = triple(bytes, at + 6 * i);
        i += 1;
    }
    triples
}

impl<const C: usize, const T: usize, const N: usize> Packed<C, T, N> {
    /// Reads a file: counts, measures, corners, normals, triangles and nodes, little-endian. Counts other than those
    /// asked for stop the compiler.
    const fn read(bytes: &[u8]) -> Self {
        let (measures, steps) = (12, 12 + 80);
        let (normals, triangles) = (steps + 6 * C, steps + 8 * C);
        let nodes = triangles + 6 * T;
        assert!(bytes.len() == nodes + 18 * N, "a mesh of other counts");
        let mut mesh = Self {
            measures: [0.0; 10],
            steps: triples(bytes, steps),
            normals: [[0; 2]; C],
            triangles: triples(bytes, triangles),
            nodes: [BvhNode::new([[0; 3]; 2], 0, 0, 0, 0); N],
        };
        let mut i = 0;
        while i < 10 {
            let Some((_, rest)) = bytes.split_at_checked(measures + 8 * i) else { break };
            let Some(value) = rest.first_chunk() else { break };
            mesh.measures[i] = f64::from_le_bytes(*value);
            i += 1;
        }
        let mut i = 0;
        while i < C {
            mesh.normals[i] = [bytes[normals + 2 * i] as i8, bytes[normals + 2 * i + 1] as i8];
            i += 1;
        }
        let mut i = 0;
        while i < N {
            let at = nodes + 18 * i;
            let bounds = [triple(bytes, at), triple(bytes, at + 6)];
            let [items, axis] = [bytes[at + 16], bytes[at + 17]];
            mesh.nodes[i] = BvhNode::new(bounds, word(bytes, at + 12), word(bytes, at + 14), items, axis);
            i += 1;
        }
        mesh
    }
}

/// Is the Utah teapot.
pub(super) static TEAPOT: Packed<530, 992, 1185> = Packed::read(include_bytes!("meshes/teapot.mesh"));
/// Is a trefoil knot of more than ten thousand triangles.
pub(super) static KNOT: Packed<5120, 10_240, 13_915> = Packed::read(include_bytes!("meshes/knot.mesh"));

/// Defines the mesh `MESH` of packed data, in the number of the module.
macro_rules! mesh {
    ($packed:ident) => {
        use crate::accel::{Bvh, Lattice};
        use crate::gallery::meshes::$packed;

        static TREE: Bvh<S> = Bvh {
            lattice: {
                let [.., x, y, z, side] = $packed.measures;
                Lattice::new(v(x, y, z), n(side))
            },
            nodes: &$packed.nodes,
            count: $packed.triangles.len() as u16,
            items: &[],
        };
        static MESH: Mesh<S> = {
            let [x, y, z, width, height, depth, ..] = $packed.measures;
            let (low, sides) = (v(x, y, z), v(width, height, depth));
            let corners = Corners::Quantized { low, sides, steps: &$packed.steps };
            Mesh::new(&$packed.triangles, corners, Normals::Octahedral(&$packed.normals), &TREE).with_bounds(
                $crate::aabb::Aabb {
                    center: v(x + 0.5 * width, y + 0.5 * height, z + 0.5 * depth),
                    half: v(0.501 * width, 0.501 * height, 0.501 * depth),
                },
            )
        };
    };
}

pub(super) use mesh;
