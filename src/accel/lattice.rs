use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};

/// Is a cube in world space whose sides are cut into 65536 steps: places in it are told by 16 bits an axis.
///
/// Boxes told by steps must be wider than what they hold, for what rounding makes of a ray: by a step, and by
/// as much as coordinates in the world are rounded. Then walks may be off by less than that and still leave
/// out nothing.
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
    /// How far it goes along the axis in a unit of distance.
    slope: S,
    /// Distance to a side's length along the axis; 0 for a ray that goes across it.
    inverse: S,
}

impl<S: Scalar> Course<S> {
    /// Answers the distance at which the ray passes a step: before the start it is negative, and of what is
    /// never passed as far as can be.
    fn reach(&self, step: u16) -> S {
        let way = share::<S>(step) - self.start;
        if self.inverse == S::ZERO { self.reach_across(way) } else { way * self.inverse }
    }

    /// Answers the distance in which the ray gets that far along an axis that it goes across: by a division,
    /// for the reciprocal is out of range.
    #[cold]
    #[inline(never)]
    fn reach_across(&self, way: S) -> S {
        if self.slope != S::ZERO {
            way.ratio(self.slope)
        } else if way < S::ZERO {
            S::FAR_BACK
        } else {
            S::FAR
        }
    }
}

/// Is where a ray enters a lattice's cube, in the cube's own measure: its side is 1 long.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry<S> {
    /// Where that is: coordinates from 0 to 1, beyond them by what rounding makes of the ray.
    pub starts: [S; 3],
    /// The ray's direction.
    pub slopes: [S; 3],
    /// Distance from the ray's start to there, in world units.
    at: S,
    side: S,
    /// Distance from the ray's start at which it leaves the cube, or up to which it looks.
    pub far: S,
}

impl<S: Scalar> Entry<S> {
    /// Answers how many sides lie between the entry and a distance from the ray's start: a little more.
    pub fn sides_to(&self, far: S) -> S {
        // 1/65536 of the side outweighs the rounding of two ratios.
        (far - self.at).ratio(self.side) + S::PARALLEL
    }
}

/// Is a ray in a lattice's own measure: the way begins where the ray enters the cube.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage<S> {
    courses: [Course<S>; 3],
    entry: Entry<S>,
    /// Distance from there up to which the ray looks.
    far: S,
}

impl<S: Scalar> Lattice<S> {
    /// Tells whether the cube lies in range.
    pub(super) fn is_in_range(&self) -> bool {
        self.low.in_range() && self.side.in_range() && self.side > S::ZERO
    }

    /// Answers where a ray enters the cube; `None` if it passes it within the interval.
    pub(super) fn enter(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Entry<S>> {
        let (mut near, mut far) = (interval.near.max(S::ZERO), interval.far);
        let from = (self.low - ray.origin).to_array();
        let slopes = ray.direction.to_array();
        for (low, slope) in from.into_iter().zip(slopes) {
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
        let at = (near - slack).max(S::ZERO);
        let starts = (ray.at(at) - self.low).to_array().map(|offset| offset.ratio(self.side));
        Some(Entry { starts, slopes, at, side: self.side, far })
    }
}

/// Tells whether a ray goes so steeply across an axis that the reciprocal of its slope is of no use: the
/// angle is less than 2^-10.
fn is_across<S: Scalar>(slope: S) -> bool {
    let least = S::SLACK + S::SLACK;
    let least = least + least;
    slope.abs() < least + least
}

impl<S: Scalar> Passage<S> {
    /// Begins where a ray enters.
    pub fn new(entry: Entry<S>) -> Self {
        let mut courses = [Course { start: S::ZERO, slope: S::ZERO, inverse: S::ZERO }; 3];
        for ((course, start), slope) in courses.iter_mut().zip(entry.starts).zip(entry.slopes) {
            let inverse = if is_across(slope) { S::ZERO } else { slope.recip() };
            *course = Course { start, slope, inverse };
        }
        Self { courses, entry, far: entry.sides_to(entry.far) }
    }

    /// Moves the far end, given as a distance from the ray's start.
    pub fn look_up_to(&mut self, far: S) {
        self.far = self.entry.sides_to(far);
    }

    /// Answers the far end.
    pub fn far(&self) -> S {
        self.far
    }

    /// Tells whether the ray goes toward lower coordinates along an axis.
    pub fn descends(&self, axis: usize) -> bool {
        self.courses.get(axis).is_some_and(|course| course.slope < S::ZERO)
    }

    /// Answers the distance at which the ray passes a step along an axis.
    pub fn reach(&self, axis: usize, step: u16) -> S {
        self.courses.get(axis).map_or(S::FAR, |course| course.reach(step))
    }

    /// Answers the step at or below which the ray is along an axis at a distance, the nearest one where that
    /// is outside the cube.
    pub fn step_at(&self, axis: usize, distance: S) -> u16 {
        let place =
            self.courses.get(axis).map_or(S::ZERO, |course| course.start.add_product(course.slope, distance));
        u16::try_from(place.light_bits() >> 8).unwrap_or(u16::MAX)
    }

    /// Answers the distances between which the ray is in a box before its far end.
    #[inline(always)]
    pub fn span(&self, [low, high]: &Steps) -> Option<(S, S)> {
        let (mut near, mut far) = (S::ZERO, self.far);
        for ((course, low), high) in self.courses.iter().zip(low).zip(high) {
            let Course { start, slope, inverse } = *course;
            let (to_low, to_high) = (share::<S>(*low) - start, share::<S>(*high) - start);
            if inverse == S::ZERO {
                // No way through the cube is longer than its diagonal, 1.74.
                let stray = slope.abs() + slope.abs();
                if to_low > stray || to_high < -stray {
                    return None;
                }
                continue;
            }
            let (first, last) = if inverse > S::ZERO { (to_low, to_high) } else { (to_high, to_low) };
            near = near.max(first * inverse);
            far = far.min(last * inverse);
            if near > far {
                return None;
            }
        }
        Some((near, far))
    }
}
