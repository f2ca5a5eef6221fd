//! The unit and the place in which a model is drawn.

use super::{Corner, Model};
use crate::bake::Bounds;
use scanray::math::Units;

/// Is how a model is moved and scaled: its base stands in the middle of the ground, y = 0, and its size suits
/// fixed point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// What becomes the origin, in the file's units.
    pub origin: [f64; 3],
    /// What a unit of the file becomes, a power of two.
    pub scale: f64,
}

/// Is how far from the middle of a model the camera may stand, in half diagonals of its box.
pub const REACH: f64 = 4.0;

impl Place {
    /// Answers the place of a model in such a box.
    ///
    /// Its half diagonal becomes 64 to 128, so that camera and light fit into the 1024 of fixed point and its
    /// corners keep 26 bits.
    pub fn of(bounds: &Bounds) -> Self {
        let half: [f64; 3] = bounds.sides().map(|side| 0.5 * side);
        let radius = half.iter().map(|half| half * half).sum::<f64>().sqrt();
        // Of what is smaller no area is left in `f64`, whatever the unit.
        let radius = if radius > 1e-100 { radius } else { 0.0 };
        let origin = [bounds.middle(0), bounds.low[1], bounds.middle(2)];
        Self { origin, scale: Units::for_largest(REACH * radius).scale() }
    }

    /// Moves and scales a model.
    pub fn apply(&self, model: &mut Model) {
        let corners = model.parts.iter_mut().flat_map(|part| part.triangles.as_flattened_mut());
        for Corner { place, .. } in corners {
            *place = std::array::from_fn(|axis| (place[axis] - self.origin[axis]) * self.scale);
        }
    }
}
