use super::super::called::{
    add_scaled, add_scaled_nearest, dot, length, normalized, product_nearest, scaled,
};
use super::hyperbola::Hyperbola;
use crate::hit::Tangent;
use crate::math::{Scalar, Vec3, turns};

/// Names the side of a cone.
pub(super) const SIDE: u16 = 0;
/// Names the cap at the base.
pub(super) const BASE: u16 = 1;
/// Names the cap at the apex.
pub(super) const APEX: u16 = 2;

/// Is where a ray enters and leaves, and through which part.
pub(super) struct Passage<S> {
    pub enter: (S, u16),
    pub leave: (S, u16),
}

/// Is a cone in its own measure.
pub(super) struct Frame<S> {
    pub middle: Vec3<S>,
    /// Unit vector from the base to the apex.
    pub axis: Vec3<S>,
    /// Half of the height.
    pub half: S,
    /// Cosine and sine of the angle at which the radius grows.
    pub slant: [S; 2],
    /// Radius in the middle, times the cosine.
    pub width: S,
}

impl<S: Scalar> Frame<S> {
    /// Answers the height over the middle, and the radius there times the cosine.
    fn level(&self, from_middle: Vec3<S>) -> [S; 2] {
        let height = dot(from_middle, self.axis);
        [height, self.width.add_product(self.slant[1], height)]
    }

    /// Answers between which distances from its nearest point the line of a ray is within the side.
    ///
    /// Products are rounded to the nearest step: in fixed point 38 of 242591 distances to cones of all sizes are
    /// then off by more than 1e-4 of them. Rounded down they would put the side a step in, and 112 would be.
    pub fn within_side(&self, near: Vec3<S>, direction: Vec3<S>) -> Option<[S; 2]> {
        let [cosine, sine] = self.slant;
        let [height, width] = self.level(near);
        let rise = dot(direction, self.axis);
        let (outward, pace) =
            normalized(add_scaled_nearest(direction, self.axis, -rise)).unwrap_or((Vec3::ZERO, S::ZERO));
        let aside = add_scaled_nearest(near, self.axis, -height);
        let along = dot(aside, outward);
        let beside = product_nearest(length(add_scaled_nearest(aside, outward, -along)), cosine);
        let line = S::normalize([product_nearest(cosine, pace), product_nearest(sine, rise), S::ZERO]);
        let Some(([x, w, _], step)) = line else {
            // Along a cylinder.
            return (beside <= width).then_some([S::FAR_BACK, S::FAR]);
        };
        let [enter, leave] =
            Hyperbola { at: [product_nearest(cosine, along), width], toward: [x, w], beside }.inside()?;
        Some([enter.ratio(step), leave.ratio(step)])
    }

    /// Answers between which distances from its nearest point the line of a ray is between the ends.
    pub fn between_ends(&self, near: Vec3<S>, direction: Vec3<S>) -> Option<Passage<S>> {
        let (height, rise) = (dot(near, self.axis), dot(direction, self.axis));
        let (to_base, to_apex) = (-self.half - height, self.half - height);
        if rise == S::ZERO {
            let inside = to_base <= S::ZERO && S::ZERO <= to_apex;
            return inside.then_some(Passage { enter: (S::FAR_BACK, BASE), leave: (S::FAR, APEX) });
        }
        let (base, apex) = ((to_base.ratio(rise), BASE), (to_apex.ratio(rise), APEX));
        let (enter, leave) = if rise > S::ZERO { (base, apex) } else { (apex, base) };
        Some(Passage { enter, leave })
    }

    /// Answers the outward normal of a part at a point near it, and how far inside the point is; `None`
    /// on the axis, where the side has no normal.
    pub fn nearest_of(&self, part: u16, from_middle: Vec3<S>) -> Option<(Vec3<S>, S)> {
        let [height, width] = self.level(from_middle);
        match part {
            BASE => Some((-self.axis, self.half + height)),
            APEX => Some((self.axis, self.half - height)),
            _ => {
                let [cosine, sine] = self.slant;
                let (outward, radius) = self.outward(from_middle)?;
                Some((add_scaled(scaled(outward, cosine), self.axis, -sine), width - radius * cosine))
            }
        }
    }

    /// Answers how high a point is of the way from the base to the apex, from 0 to below 1.
    pub fn share(&self, from_middle: Vec3<S>) -> S {
        let share = (dot(from_middle, self.axis) + self.half).ratio(self.half) * S::HALF;
        share.max(S::ZERO).min(S::BELOW_ONE)
    }

    /// Answers the unit vectors across the axis from which, and toward which, the angle around it is
    /// measured: of a cone along y these are x and z, as on a ball.
    fn across(&self) -> [Vec3<S>; 2] {
        let Vec3 { x, y, z } = self.axis;
        let (first, along) = if x.abs() > y.abs() && x.abs() > z.abs() {
            (Vec3::new(S::ZERO, S::ONE, S::ZERO), y)
        } else {
            (Vec3::new(S::ONE, S::ZERO, S::ZERO), x)
        };
        let from = normalized(add_scaled(first, self.axis, -along)).map_or(first, |(unit, _)| unit);
        [from, from.cross(self.axis)]
    }

    /// Answers the unit vector from the axis to a point, and how far out it is; `None` on the axis.
    fn outward(&self, from_middle: Vec3<S>) -> Option<(Vec3<S>, S)> {
        normalized(add_scaled(from_middle, self.axis, -dot(from_middle, self.axis)))
    }

    /// Answers how far a point is around the axis, in turns from 0 to below 1; on the axis 0.
    pub fn turn(&self, from_middle: Vec3<S>) -> S {
        let Some((outward, _)) = self.outward(from_middle) else { return S::ZERO };
        let [x, z] = self.across().map(|axis| dot(outward, axis));
        (S::ONE - turns(z, x)).min(S::BELOW_ONE)
    }

    /// Answers the ways along which turn and share grow on the side at a point near it: around the axis
    /// `2 pi r` to a turn, and from the base to the apex the length of the side's lines.
    pub fn tangents(&self, from_middle: Vec3<S>) -> [Tangent<S>; 2] {
        let (outward, radius) = self.outward(from_middle).unwrap_or((Vec3::ZERO, S::ZERO));
        let half_circle = S::PI * radius;
        let [cosine, sine] = self.slant;
        let half_line = self.half.ratio(cosine);
        [
            Tangent { direction: self.axis.cross(outward), length: half_circle + half_circle },
            Tangent {
                direction: add_scaled(scaled(self.axis, cosine), outward, sine),
                length: half_line + half_line,
            },
        ]
    }

    /// Answers how far a disc of radius 1 across the axis reaches along each of the world's axes.
    pub fn reach_across(&self) -> Vec3<S> {
        let Vec3 { x, y, z } = self.axis;
        let reach = |p: S, q: S| length(Vec3::new(p, q, S::ZERO));
        Vec3::new(reach(y, z), reach(z, x), reach(x, y))
    }
}
