use super::hyperbola::Hyperbola;
use crate::math::{Scalar, Vec3};

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
        let height = from_middle.dot(self.axis);
        [height, self.width.add_product(self.slant[1], height)]
    }

    /// Answers between which distances from its nearest point the line of a ray is within the side.
    pub fn within_side(&self, near: Vec3<S>, direction: Vec3<S>) -> Option<[S; 2]> {
        let [cosine, sine] = self.slant;
        let [height, width] = self.level(near);
        let rise = direction.dot(self.axis);
        let (outward, pace) =
            direction.add_scaled(self.axis, -rise).normalize().unwrap_or((Vec3::ZERO, S::ZERO));
        let aside = near.add_scaled(self.axis, -height);
        let along = aside.dot(outward);
        let beside = aside.add_scaled(outward, -along).length() * cosine;
        let line = S::normalize([cosine * pace, sine * rise, S::ZERO]);
        let Some(([x, w, _], step)) = line else {
            // Along a cylinder.
            return (beside <= width).then_some([S::FAR_BACK, S::FAR]);
        };
        let [enter, leave] = Hyperbola { at: [cosine * along, width], toward: [x, w], beside }.inside()?;
        Some([enter.ratio(step), leave.ratio(step)])
    }

    /// Answers between which distances from its nearest point the line of a ray is between the ends.
    pub fn between_ends(&self, near: Vec3<S>, direction: Vec3<S>) -> Option<Passage<S>> {
        let (height, rise) = (near.dot(self.axis), direction.dot(self.axis));
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
                let (outward, radius) = from_middle.add_scaled(self.axis, -height).normalize()?;
                Some(((outward * cosine).add_scaled(self.axis, -sine), width - radius * cosine))
            }
        }
    }

    /// Answers how high a point is of the way from the base to the apex, from 0 to below 1.
    pub fn share(&self, point: Vec3<S>) -> S {
        let share = ((point - self.middle).dot(self.axis) + self.half).ratio(self.half) * S::HALF;
        share.max(S::ZERO).min(S::BELOW_ONE)
    }

    /// Answers how far a disc of radius 1 across the axis reaches along each of the world's axes.
    pub fn reach_across(&self) -> Vec3<S> {
        let Vec3 { x, y, z } = self.axis;
        let reach = |p: S, q: S| Vec3::new(p, q, S::ZERO).length();
        Vec3::new(reach(y, z), reach(z, x), reach(x, y))
    }
}
