use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};

/// Is a cube in world space whose sides are cut into 65536 steps: places in it are told by 16 bits an axis.
///
/// Boxes told by steps must be wider than what they hold by a share for rounding: [`Lattice::margin`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice<S = f32> {
    /// The corner of the lowest coordinates.
    pub low: Vec3<S>,
    /// Length of a side, above 0.
    pub side: S,
}

impl<S> Lattice<S> {
    /// Makes a lattice of its lowest corner and the length of its sides.
    pub const fn new(low: Vec3<S>, side: S) -> Self {
        Self { low, side }
    }
}

/// Is a box in steps of a lattice: lowest and highest corner.
pub(super) type Steps = [[u16; 3]; 2];

/// Answers a step's place as a share of the side, from 0 to below 1.
fn share<S: Scalar>(step: u16) -> S {
    S::from_light_bits(u32::from(step) << 8)
}

/// Is how a ray goes along one axis of a lattice, in sides.
#[derive(Clone, Copy, Debug)]
struct Course<S> {
    /// Where it enters the cube.
    start: S,
    /// Distance to a side's length along the axis; 0 for a ray that goes across it.
    inverse: S,
    /// How far a ray that goes across the axis strays along it within the cube.
    stray: S,
}

/// Is a ray in a lattice's own measure: the cube's side is 1 long, and the way begins where the ray enters
/// the cube.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage<S> {
    courses: [Course<S>; 3],
    /// Distance from the ray's start to where it enters, in world units.
    entry: S,
    side: S,
    /// Distance from there up to which the ray looks.
    far: S,
}

impl<S: Scalar> Lattice<S> {
    /// Tells whether the cube lies in range.
    pub(super) fn is_in_range(&self) -> bool {
        self.low.in_range() && self.side.in_range() && self.side > S::ZERO
    }

    /// Answers the ray from where it enters the cube on; `None` if it passes it within the interval.
    pub(super) fn enter(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Passage<S>> {
        let (mut near, mut far) = (interval.near.max(S::ZERO), interval.far);
        let from = (self.low - ray.origin).to_array();
        let along = ray.direction.to_array();
        for (low, slope) in from.into_iter().zip(along) {
            if is_across(slope) {
                continue;
            }
            let (a, b) = (low.ratio(slope), (low + self.side).ratio(slope));
            (near, far) = (near.max(a.min(b)), far.min(a.max(b)));
        }
        let slack = (near + self.side) * S::SLACK;
        if near > far + slack {
            return None;
        }
        let entry = (near - slack).max(S::ZERO);
        let offset = (ray.at(entry) - self.low).to_array();
        let mut courses = [Course { start: S::ZERO, inverse: S::ZERO, stray: S::ZERO }; 3];
        for ((course, offset), slope) in courses.iter_mut().zip(offset).zip(along) {
            let start = offset.ratio(self.side);
            *course = if is_across(slope) {
                // No way through the cube is longer than its diagonal, 1.74.
                Course { start, inverse: S::ZERO, stray: slope.abs() + slope.abs() }
            } else {
                Course { start, inverse: slope.recip(), stray: S::ZERO }
            };
        }
        let mut passage = Passage { courses, entry, side: self.side, far: S::ZERO };
        passage.look_up_to(far);
        Some(passage)
    }
}

/// Tells whether a ray goes so steeply across an axis that the reciprocal of its slope is of no use: the angle
/// is less than 2^-10.
fn is_across<S: Scalar>(slope: S) -> bool {
    let least = S::SLACK + S::SLACK;
    let least = least + least;
    slope.abs() < least + least
}

impl<S: Scalar> Passage<S> {
    /// Moves the far end, given as a distance from the ray's start.
    pub fn look_up_to(&mut self, far: S) {
        // 1/65536 of the side outweighs the rounding of two ratios.
        self.far = (far - self.entry).ratio(self.side) + S::PARALLEL;
    }

    /// Tells whether the ray goes toward lower coordinates along an axis.
    pub fn descends(&self, axis: usize) -> bool {
        self.courses.get(axis).is_some_and(|course| course.inverse < S::ZERO)
    }

    /// Tells whether the ray meets a box before its far end.
    pub fn meets(&self, [low, high]: &Steps) -> bool {
        let (mut near, mut far) = (S::ZERO, self.far);
        for ((course, low), high) in self.courses.iter().zip(low).zip(high) {
            let Course { start, inverse, stray } = *course;
            let (to_low, to_high) = (share::<S>(*low) - start, share::<S>(*high) - start);
            if inverse == S::ZERO {
                if to_low > stray || to_high < -stray {
                    return false;
                }
                continue;
            }
            let (first, last) = if inverse > S::ZERO { (to_low, to_high) } else { (to_high, to_low) };
            near = near.max(first * inverse);
            far = far.min(last * inverse);
            if near > far {
                return false;
            }
        }
        true
    }
}
