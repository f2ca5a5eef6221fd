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
        // A side has 65536 steps of which the last is never reached.
        let sides = bounds.sides().map(|side| (side * 65_536.0 / 65_535.0).max(1e-6));
        let steps: Vec<[u16; 3]> =
            self.places.iter().map(|place| quantize(place, &bounds.low, &sides)).collect();
        let place = |corner: u16| {
            let steps = steps[usize::from(corner)];
            std::array::from_fn(|axis| bounds.low[axis] + sides[axis] * f64::from(steps[axis]) / 65_536.0)
        };
        let boxes: Vec<Bounds> =
            self.triangles.iter().map(|corners| Bounds::around(corners.map(place))).collect();
        let bvh = Bvh::build(&boxes);
        let lattice = bvh.lattice::<f64>();
        Packed {
            bounds: Bounds {
                low: bounds.low,
                high: std::array::from_fn(|axis| bounds.low[axis] + sides[axis]),
            },
            normals: self.normals.iter().map(fold).collect(),
            triangles: bvh.order.iter().map(|triangle| self.triangles[usize::from(*triangle)]).collect(),
            nodes: bvh.nodes,
            lattice_low: lattice.low.to_array(),
            lattice_side: lattice.side,
            steps,
        }
    }
}

fn quantize(place: &[f64; 3], low: &[f64; 3], sides: &[f64; 3]) -> [u16; 3] {
    std::array::from_fn(|axis| ((place[axis] - low[axis]) / sides[axis] * 65_536.0).round() as u16)
}

/// Answers the octahedron's point whose unit vector is nearest to a normal: of the four around its image.
fn fold(normal: &[f64; 3]) -> [i16; 2] {
    let [x, y, z] = *normal;
    let length = x.abs() + y.abs() + z.abs();
    let [u, v] = [x / length, y / length];
    let over = |this: f64, other: f64| (1.0 - other.abs()).copysign(this);
    let [u, v] = if z < 0.0 { [over(u, v), over(v, u)] } else { [u, v] };
    let around =
        |value: f64| [value.floor(), value.ceil()].map(|step| step.clamp(-32_767.0, 32_767.0) as i16);
    let points = around(u * 32_767.0).into_iter().flat_map(|u| around(v * 32_767.0).map(|v| [u, v]));
    let nearness = |point: &[i16; 2]| {
        let unfolded = unfold(*point);
        (0..3).map(|axis| unfolded[axis] * normal[axis]).sum::<f64>()
    };
    points.max_by(|a, b| nearness(a).total_cmp(&nearness(b))).unwrap_or_default()
}

/// Answers the unit vector of an octahedron's point.
fn unfold(point: [i16; 2]) -> [f64; 3] {
    let [u, v] = point.map(|step| f64::from(step) / 32_767.0);
    let z = 1.0 - u.abs() - v.abs();
    let below = (-z).max(0.0);
    let place = [u - below.copysign(u), v - below.copysign(v), z];
    let length = place.iter().map(|value| value * value).sum::<f64>().sqrt();
    place.map(|value| value / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_normal_comes_back_within_4_thousandths_of_a_degree() {
        let mut worst = 0.0_f64;
        for i in 0..4000 {
            let (z, phi) = (1.0 - 2.0 * (f64::from(i) + 0.5) / 4000.0, f64::from(i) * 2.399_963);
            let r = (1.0 - z * z).sqrt();
            let normal = [r * phi.cos(), r * phi.sin(), z];
            let back = unfold(fold(&normal));
            let off: f64 = (0..3).map(|axis| (back[axis] - normal[axis]).powi(2)).sum();
            worst = worst.max(off.sqrt().to_degrees());
        }
        assert!(worst < 0.004, "{worst} degrees");
        assert!(worst > 0.001, "{worst} degrees: is anything quantised?");
    }
}
