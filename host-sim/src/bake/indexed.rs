use super::octahedron::fold;
use super::steps::Steps;
use super::{Bounds, Bvh};
use scanray::accel::BvhNode;

/// Is triangles that share their corners, each corner with a normal.
#[derive(Clone, Debug, Default)]
pub struct Indexed {
    /// Where the corners are.
    pub places: Vec<[f64; 3]>,
    /// Unit normals of the surface there.
    pub normals: Vec<[f64; 3]>,
    /// Numbers of the corners, anticlockwise as seen from outside.
    pub triangles: Vec<[u16; 3]>,
}

/// Is a mesh as it lies in flash: [`scanray::Corners::Quantized`], [`scanray::Normals::Octahedral`] and a tree of
/// boxes in whose order the triangles are.
#[derive(Clone, Debug)]
pub struct Packed {
    /// The box of the corners.
    pub bounds: Bounds,
    /// The corners in 65536ths of its sides.
    pub steps: Vec<[u16; 3]>,
    /// The normals on the octahedron.
    pub normals: Vec<[i16; 2]>,
    /// The triangles in the order of the leaves.
    pub triangles: Vec<[u16; 3]>,
    /// The tree's nodes.
    pub nodes: Vec<BvhNode>,
    /// The lowest corner of the tree's lattice.
    pub lattice_low: [f64; 3],
    /// The length of its sides.
    pub lattice_side: f64,
}

impl Indexed {
    /// Packs the mesh.
    pub fn pack(&self) -> Packed {
        let bounds = Bounds::around(self.places.iter().copied());
        let grid = Steps::over(&bounds);
        let steps: Vec<[u16; 3]> = self.places.iter().map(|place| grid.steps(*place)).collect();
        let place = |corner: u16| grid.place(steps[usize::from(corner)]);
        let boxes: Vec<Bounds> =
            self.triangles.iter().map(|corners| Bounds::around(corners.map(place))).collect();
        let bvh = Bvh::build(&boxes);
        let lattice = bvh.lattice::<f64>();
        Packed {
            bounds: Bounds {
                low: bounds.low,
                high: std::array::from_fn(|axis| bounds.low[axis] + grid.sides[axis]),
            },
            normals: self.normals.iter().map(|normal| fold(*normal)).collect(),
            triangles: bvh.order.iter().map(|triangle| self.triangles[usize::from(*triangle)]).collect(),
            nodes: bvh.nodes,
            lattice_low: lattice.low.to_array(),
            lattice_side: lattice.side,
            steps,
        }
    }
}
