use super::roots::{Ray, Root};
use super::vector::Vector;
use std::sync::Arc;

/// Is a field sampled on a Cartesian grid.
#[derive(Clone, Debug)]
pub(super) struct Field {
    /// Values by slice, row and column.
    pub samples: Arc<Vec<Vec<Vec<f64>>>>,
    pub low: Vector,
    pub spacing: Vector,
    /// Whether the gradient is that of the mixed values, of the first order, or that of central differences.
    pub first_order: bool,
}

/// Is the piece of a line in one cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub cell: [usize; 3],
    pub from: f64,
    pub to: f64,
}

/// Lists the eight corners of a cell.
fn corners() -> impl Iterator<Item = [usize; 3]> {
    (0..8).map(|corner| [corner & 1, corner >> 1 & 1, corner >> 2])
}

impl Field {
    fn sides(&self) -> [usize; 3] {
        [self.samples[0][0].len(), self.samples[0].len(), self.samples.len()]
    }

    /// Answers the value at a node, which may lie a step outside of the grid: the field goes on in straight lines.
    fn node(&self, node: [i64; 3]) -> f64 {
        let sides = self.sides();
        for axis in 0..3 {
            let last = sides[axis] as i64 - 1;
            let beyond = if node[axis] < 0 { 1 } else { -i64::from(node[axis] > last) };
            if beyond != 0 {
                let inward = |steps: i64| {
                    let mut moved = node;
                    moved[axis] += beyond * steps;
                    self.node(moved)
                };
                return 2.0 * inward(1) - inward(2);
            }
        }
        let [i, j, k] = node.map(|index| index as usize);
        self.samples[k][j][i]
    }

    /// Answers the nodes at the corners of a cell, and the weight of each at a place that many nodes from the first.
    fn weighted(cell: [usize; 3], place: Vector) -> impl Iterator<Item = ([i64; 3], f64)> {
        corners().map(move |corner| {
            let node = [0, 1, 2].map(|axis| (cell[axis] + corner[axis]) as i64);
            let weight = |axis: usize| {
                let share = place.0[axis] - cell[axis] as f64;
                if corner[axis] == 1 { share } else { 1.0 - share }
            };
            (node, weight(0) * weight(1) * weight(2))
        })
    }

    /// Answers the field in a cell: the sum of its corners' values by their weights.
    pub fn value(&self, cell: [usize; 3], place: Vector) -> f64 {
        Self::weighted(cell, place).map(|(node, weight)| weight * self.node(node)).sum()
    }

    /// Answers the place of a point, counted in nodes.
    pub fn counted(&self, point: Vector) -> Vector {
        Vector::by_axis(|axis| (point.0[axis] - self.low.0[axis]) / self.spacing.0[axis])
    }

    /// Answers the gradient in a cell.
    pub fn gradient(&self, cell: [usize; 3], place: Vector) -> Vector {
        Vector::by_axis(|axis| {
            let shifted = |steps: i64| -> f64 {
                let moved = |(mut node, weight): ([i64; 3], f64)| {
                    node[axis] += steps;
                    weight * self.node(node)
                };
                Self::weighted(cell, place).map(moved).sum()
            };
            let at = |level: usize| {
                let mut face = place;
                face.0[axis] = (cell[axis] + level) as f64;
                self.value(cell, face)
            };
            let rise = if self.first_order { at(1) - at(0) } else { (shifted(1) - shifted(-1)) / 2.0 };
            rise / self.spacing.0[axis]
        })
    }

    /// Cuts a line at all planes of nodes and answers the pieces inside the grid, in order.
    pub fn pieces(&self, ray: &Ray) -> Vec<Piece> {
        let (start, end) = (self.counted(ray.start), self.counted(ray.start + ray.direction));
        let (rate, sides) = (end - start, self.sides());
        let mut cuts = vec![];
        for (axis, side) in sides.into_iter().enumerate() {
            let planes = (0..side).map(|plane| (plane as f64 - start.0[axis]) / rate.0[axis]);
            cuts.extend(planes.filter(|t| t.is_finite()));
        }
        cuts.sort_by(f64::total_cmp);
        let piece = |ends: &[f64]| {
            let (from, to) = (ends[0], ends[1]);
            let middle = start + rate * ((from + to) / 2.0);
            let cell = middle.0.map(|place| place.floor());
            let inside = (0..3).all(|axis| 0.0 <= cell[axis] && cell[axis] < (sides[axis] - 1) as f64);
            (inside && from < to).then(|| Piece { cell: cell.map(|index| index as usize), from, to })
        };
        cuts.windows(2).filter_map(piece).collect()
    }

    /// Tells whether a cell has corners on both sides of a level.
    fn straddles(&self, cell: [usize; 3], level: f64) -> bool {
        let above = corners().filter(|corner| {
            let [i, j, k] = [0, 1, 2].map(|axis| cell[axis] + corner[axis]);
            self.samples[k][j][i] >= level
        });
        (1..8).contains(&above.count())
    }

    /// Answers all places where a line goes through the level: those where some of many small steps changes sides.
    ///
    /// Their part is twice their number, and one more where the line comes out: pixels that see through other folds
    /// of the surface have other parts.
    pub fn roots(&self, ray: &Ray, level: f64) -> Vec<Root> {
        const STEPS: u32 = 24;
        let mut roots: Vec<Root> = vec![];
        for Piece { cell, from, to } in self.pieces(ray) {
            if !self.straddles(cell, level) {
                continue;
            }
            let inside = |t: f64| self.value(cell, self.counted(ray.point(t))) >= level;
            let at = |step: u32| from + (to - from) * f64::from(step) / f64::from(STEPS);
            let sides: Vec<bool> = (0..=STEPS).map(|step| inside(at(step))).collect();
            for step in (0..STEPS).filter(|step| sides[*step as usize] != sides[*step as usize + 1]) {
                let (mut low, mut high) = (at(step), at(step + 1));
                for _ in 0..60 {
                    let middle = (low + high) / 2.0;
                    if inside(middle) == sides[step as usize] { low = middle } else { high = middle }
                }
                let fold = (2 * roots.len()).min(254) as u8;
                roots.push(Root { t: low, part: fold + u8::from(sides[step as usize]) });
            }
        }
        roots
    }

    /// Answers the unit normal toward lower values at a point.
    pub fn normal(&self, point: Vector) -> Vector {
        let (place, sides) = (self.counted(point), self.sides());
        let cell = [0, 1, 2].map(|axis| (place.0[axis].max(0.0) as usize).min(sides[axis] - 2));
        -self.gradient(cell, place).unit()
    }
}
