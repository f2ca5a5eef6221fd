use super::{Bounds, Cube};

/// Is a box in steps of a cube: lowest and highest corner.
pub(super) type Steps = [[u16; 3]; 2];

/// Is the boxes of many things in steps of the cube around them all, as trees that cut space see them.
#[derive(Clone, Debug)]
pub(super) struct Boxes {
    pub cube: Cube,
    /// The box around them all.
    pub whole: Steps,
    /// The box of each thing. Each is wider than what it holds, so that none is flat.
    pub each: Vec<Steps>,
}

impl Boxes {
    pub fn new(things: &[Bounds]) -> Self {
        let cube = Cube::around(&Bounds::of(things.iter().copied()));
        let each: Vec<Steps> = things.iter().map(|thing| cube.steps(thing)).collect();
        let around = |[low, high]: Steps, [l, h]: &Steps| {
            [[0, 1, 2].map(|i| low[i].min(l[i])), [0, 1, 2].map(|i| high[i].max(h[i]))]
        };
        let whole = each.iter().fold([[u16::MAX; 3], [0; 3]], around);
        Self { cube, whole, each }
    }

    /// Answers the numbers of all things.
    pub fn all(&self) -> Vec<u16> {
        (0..self.each.len() as u16).collect()
    }
}

/// Answers half the area of a box's surface, in squares of steps.
pub(super) fn half_area([low, high]: &Steps) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|axis| f64::from(high[axis].saturating_sub(low[axis])));
    x * y + y * z + z * x
}
