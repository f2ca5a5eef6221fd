use super::Bounds;
use crate::rounded::Rounded;
use scanray::Vec3;
use scanray::accel::Lattice;

/// Counts the steps of a lattice's side.
const STEPS: f64 = 65_536.0;

/// Is the cube around many boxes, and tells boxes in it by steps of its sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cube {
    low: [f64; 3],
    side: f64,
    /// By how much boxes are wider than what they hold, in world units.
    margin: f64,
}

impl Cube {
    /// Makes the cube around a box.
    ///
    /// What is told in it is widened by 8 steps of fixed point, 2^-17, and by 8 roundings of `f32` at the
    /// largest coordinate: where a ray enters the cube is a sum of two rounded products, and a triangle is
    /// met 1/65536 beyond its edges.
    pub fn around(bounds: &Bounds) -> Self {
        let widest = bounds.sides().into_iter().fold(0.0, f64::max);
        let margin = 2_f64.powi(-17) + bounds.largest() * 2_f64.powi(-20) + widest / STEPS;
        // Two steps for rounding down and up, and no cube so small that fixed point has no digits left for
        // it.
        let side = ((widest + 4.0 * margin) * (1.0 + 4.0 / STEPS)).max(1.0 / 64.0);
        let low = std::array::from_fn(|axis| bounds.middle(axis) - 0.5 * side);
        let low = if bounds.low[0].is_finite() { low } else { [0.0; 3] };
        Self { low, side, margin }
    }

    /// Answers the cube as the core has it.
    pub fn lattice<S: Rounded>(&self) -> Lattice<S> {
        Lattice::new(Vec3::from_array(self.low.map(S::round)), S::round(self.side))
    }

    /// Answers the steps between which a box lies, the margin included.
    pub fn steps(&self, bounds: &Bounds) -> [[u16; 3]; 2] {
        let step = |value: f64, axis: usize| (value - self.low[axis]) / self.side * STEPS;
        let low = std::array::from_fn(|axis| step(bounds.low[axis] - self.margin, axis).floor() as u16);
        let high = std::array::from_fn(|axis| step(bounds.high[axis] + self.margin, axis).ceil() as u16);
        [low, high]
    }
}
