use crate::fault::Fault;
use crate::math::{Scalar, Vec3};

/// Holds the places of a mesh's corners, which triangles share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Corners<S: 'static = f32> {
    /// In the number itself: 12 bytes each.
    Exact(&'static [Vec3<S>]),
    /// In 65536 steps along each side of a box: 6 bytes each, and at most half a step off, 1/131072 of the side.
    Quantized {
        /// The box's corner of the lowest coordinates.
        low: Vec3<S>,
        /// Lengths of its sides.
        sides: Vec3<S>,
        /// Steps from there along each axis.
        steps: &'static [[u16; 3]],
    },
}

impl<S: Scalar> Corners<S> {
    /// Answers how many there are.
    pub const fn len(&self) -> usize {
        match self {
            Self::Exact(places) => places.len(),
            Self::Quantized { steps, .. } => steps.len(),
        }
    }

    /// Tells whether there is none.
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Answers where a corner is; of one that is not in the list, the origin.
    pub(super) fn place(&self, number: u16) -> Vec3<S> {
        let number = usize::from(number);
        match self {
            Self::Exact(places) => places.get(number).copied().unwrap_or(Vec3::ZERO),
            Self::Quantized { low, sides, steps } => {
                let Some([x, y, z]) = steps.get(number).copied() else { return Vec3::ZERO };
                let share = |step: u16| S::from_light_bits(u32::from(step) << 8);
                *low + Vec3::new(share(x) * sides.x, share(y) * sides.y, share(z) * sides.z)
            }
        }
    }

    pub(super) fn check(&self) -> Result<(), Fault> {
        let in_range = match self {
            Self::Exact(places) => places.iter().all(|place| place.in_range()),
            Self::Quantized { low, sides, .. } => {
                low.in_range() && (*low + *sides).in_range() && sides.in_range()
            }
        };
        if in_range { Ok(()) } else { Err(Fault::OutOfRange) }
    }
}
