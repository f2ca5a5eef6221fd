//! What a hull cuts out of a fan: the slopes between which its rays can meet it.
//!
//! In the plane of a fan a ball is a disc, seen between its two tangents; a polyhedron is a
//! polygon, seen between its outermost corners; a plane is seen on one side of its horizon. Each
//! is taken a little too large ([`Scalar::SLACK`]), so that rounding never loses a ray.

use super::Fan;
use super::fan::Slopes;
use crate::aabb::Aabb;
use crate::hull::Hull;
use crate::math::{Scalar, Vec3};

/// Is a point seen from the fan: how far along the row, how far toward the scene, how far off the
/// plane of the fan.
pub(crate) type Place<S> = [S; 3];

impl<S: Scalar> Fan<S> {
    const ALL: Slopes<S> = [S::FAR_BACK, S::FAR];

    /// Answers the slopes of the rays that can meet the hull; `None` if none can.
    pub(super) fn section(&self, hull: &Hull<S>) -> Option<Slopes<S>> {
        match *hull {
            Hull::Ball { center, radius } => {
                let [p, q, off] = self.place(center);
                let reach = radius + slack([p, q, off]);
                let square = reach.mul_wide(reach) - off.mul_wide(off);
                (off.abs() <= reach).then(|| self.disc([p, q], S::sqrt(square)))?
            }
            Hull::Box(bounds) => self.polygon(&self.box_corners(&bounds), &BOX_EDGES),
            Hull::Triangle(corners) => self.polygon(&corners.map(|c| self.place(c)), &TRIANGLE_EDGES),
            Hull::Plane { point, normal } => self.half(point, normal),
            Hull::Everything => Some(Self::ALL),
        }
    }

    /// Answers the slopes between which the hull lies when all of it is dropped onto the fan.
    pub(super) fn projection(&self, hull: &Hull<S>) -> Option<Slopes<S>> {
        match *hull {
            Hull::Ball { center, radius } => {
                let place = self.place(center);
                self.disc([place[0], place[1]], radius + slack(place))
            }
            Hull::Box(bounds) => self.shadow(&self.box_corners(&bounds)),
            Hull::Triangle(corners) => self.shadow(&corners.map(|c| self.place(c))),
            Hull::Plane { .. } | Hull::Everything => Some(Self::ALL),
        }
    }

    /// Answers where a point lies: along the row, toward the scene, off the plane of the fan.
    pub(crate) fn place(&self, point: Vec3<S>) -> Place<S> {
        self.turn(point - self.apex)
    }

    fn turn(&self, v: Vec3<S>) -> Place<S> {
        [v.dot(self.along), v.dot(self.toward), v.dot(self.across)]
    }

    /// Answers the slopes of a disc's tangents.
    fn disc(&self, [p, q]: [S; 2], radius: S) -> Option<Slopes<S>> {
        if self.parallel {
            return (q + radius > S::ZERO).then_some([p - radius, p + radius]);
        }
        let Some(([sine, cosine, _], distance)) = S::normalize([p, q, S::ZERO]) else {
            return Some(Self::ALL);
        };
        if radius >= distance {
            return Some(Self::ALL);
        }
        // The middle's direction, turned to either side by the angle under which the radius is seen.
        let half_sine = S::div(radius.mul_wide(S::ONE), distance.mul_wide(S::ONE));
        let half_cosine = S::sqrt(S::ONE.mul_wide(S::ONE) - half_sine.mul_wide(half_sine));
        let (a, b) = (sine * half_cosine, cosine * half_sine);
        let (c, d) = (cosine * half_cosine, sine * half_sine);
        match (slope(a - b, c + d), slope(a + b, c - d)) {
            (None, None) => None,
            (low, high) => Some([low.unwrap_or(S::FAR_BACK), high.unwrap_or(S::FAR)]),
        }
    }

    /// Answers the slopes from which a plane is met in front and not behind.
    fn half(&self, point: Vec3<S>, normal: Vec3<S>) -> Option<Slopes<S>> {
        let Some((normal, _)) = normal.normalize() else { return Some(Self::ALL) };
        let height = (point - self.apex).dot(normal);
        if self.parallel || height.abs() <= slack(self.place(point)) {
            return Some(Self::ALL);
        }
        let facing = if height > S::ZERO { normal } else { -normal };
        let (rise, level) = (facing.dot(self.along), facing.dot(self.toward));
        let tolerance = |slope: S| (S::ONE + slope.abs()) * S::SLACK;
        let met = |slope: S| level + slope * rise >= -tolerance(slope);
        let (first, last) = (met(self.start), met(self.start + self.extent));
        if first == last {
            return first.then_some(Self::ALL);
        }
        let horizon = S::div(-level.mul_wide(S::ONE), rise.mul_wide(S::ONE));
        // Where the row crosses the horizon at a small angle, rounding moves the crossing far.
        let moved = S::div(tolerance(horizon).mul_wide(S::ONE), rise.abs().mul_wide(S::ONE));
        if first == (self.extent > S::ZERO) {
            Some([S::FAR_BACK, horizon + moved])
        } else {
            Some([horizon - moved, S::FAR])
        }
    }

    /// Answers the corners of a box, named by bits: a bit an axis, set where it is the high one.
    pub(crate) fn box_corners(&self, bounds: &Aabb<S>) -> [Place<S>; 8] {
        let center = self.place(bounds.center);
        let [x, y, z] = bounds.half.to_array();
        let halves = [
            self.turn(Vec3::new(x, S::ZERO, S::ZERO)),
            self.turn(Vec3::new(S::ZERO, y, S::ZERO)),
            self.turn(Vec3::new(S::ZERO, S::ZERO, z)),
        ];
        core::array::from_fn(|corner| {
            let mut place = center;
            for (axis, half) in halves.iter().enumerate() {
                let outward = corner >> axis & 1 == 1;
                for (at, step) in place.iter_mut().zip(half) {
                    *at = if outward { *at + *step } else { *at - *step };
                }
            }
            place
        })
    }

    /// Answers the slopes of the polygon that a polyhedron's edges cut out of the plane of the fan.
    fn polygon(&self, corners: &[Place<S>], edges: &[[u8; 2]]) -> Option<Slopes<S>> {
        let mut seen = Seen::NOTHING;
        for corner in corners.iter().filter(|corner| corner[2].abs() <= slack(**corner)) {
            seen.add(self, *corner);
        }
        for [i, j] in edges {
            let ends = (corners.get(usize::from(*i)), corners.get(usize::from(*j)));
            let (Some(a), Some(b)) = ends else { continue };
            if (a[2] < S::ZERO) != (b[2] < S::ZERO) {
                let share = S::div(a[2].mul_wide(S::ONE), (a[2] - b[2]).mul_wide(S::ONE));
                seen.add(self, [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, S::ZERO]);
            }
        }
        seen.slopes()
    }

    /// Answers the slopes between the outermost of some points, dropped onto the fan.
    fn shadow(&self, corners: &[Place<S>]) -> Option<Slopes<S>> {
        let mut seen = Seen::NOTHING;
        corners.iter().for_each(|corner| seen.add(self, *corner));
        seen.slopes()
    }
}

const TRIANGLE_EDGES: [[u8; 2]; 3] = [[0, 1], [1, 2], [2, 0]];
/// Names the corners of a box by bits, a bit an axis.
const BOX_EDGES: [[u8; 2]; 12] =
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

/// Answers by how much a point's place may be wrong: 2^-13 of its distance.
///
/// Rays and places are rounded to 2^-20 and better; near the eye what counts is a step.
fn slack<S: Scalar>([p, q, off]: Place<S>) -> S {
    (p.abs() + q.abs() + off.abs() + S::ONE) * S::SLACK
}

/// Answers the slope of a direction; `None` where it points back, or so far aside that no row does.
fn slope<S: Scalar>(along: S, toward: S) -> Option<S> {
    (toward > S::SLACK).then(|| S::div(along.mul_wide(S::ONE), toward.mul_wide(S::ONE)))
}

/// Gathers the points of a polygon.
struct Seen<S> {
    low: S,
    high: S,
    ahead: bool,
    beside: bool,
    behind: bool,
}

impl<S: Scalar> Seen<S> {
    const NOTHING: Self = Self { low: S::FAR, high: S::FAR_BACK, ahead: false, beside: false, behind: false };

    fn add(&mut self, fan: &Fan<S>, place: Place<S>) {
        let [p, q, _] = place;
        let margin = slack(place);
        if q < -margin {
            self.behind = true;
        } else if q <= margin && !fan.parallel {
            self.beside = true;
        } else {
            self.ahead = true;
            let (at, moved) = if fan.parallel {
                (p, margin)
            } else {
                let at = S::div(p.mul_wide(S::ONE), q.mul_wide(S::ONE));
                // A point that is off by `margin` is seen off by margin / q (1 + |slope|).
                (at, S::div(((S::ONE + at.abs()) * margin).mul_wide(S::ONE), q.mul_wide(S::ONE)))
            };
            self.low = self.low.min(at - moved);
            self.high = self.high.max(at + moved);
        }
    }

    fn slopes(&self) -> Option<Slopes<S>> {
        if self.beside || (self.ahead && self.behind) {
            return Some(Fan::ALL);
        }
        self.ahead.then_some([self.low, self.high])
    }
}
