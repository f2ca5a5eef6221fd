use super::frame::{Frame, index};
use crate::math::{Scalar, WideVec3};
use crate::ray::{Interval, Ray};

/// Is how many columns are reached by adding, before a multiplication wipes out the rounding.
///
/// 32 additions in `f32` drift by at most 32 half-steps, 2e-6 of the window: 1/1600 of a pixel at
/// 320 columns. Fixed point adds 40-bit fractions and drifts less than its own step.
const ANCHOR: i32 = 32;

/// Is the iterator over the rays of one row, from left to right, by forward differences.
#[derive(Clone, Debug)]
pub struct Row<'f, S: Scalar> {
    frame: &'f Frame<S>,
    start: WideVec3<S>,
    step: WideVec3<S>,
    at: WideVec3<S>,
    x: i32,
}

/// Is a primary ray with the distances between which the camera sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowRay<S = f32> {
    /// The ray, with a unit direction.
    pub ray: Ray<S>,
    /// From the near to the far plane along it.
    pub interval: Interval<S>,
    /// How far along the ray a depth of 1 is; 1 for parallel rays.
    pub length: S,
}

impl<'f, S: Scalar> Row<'f, S> {
    pub(super) fn new(frame: &'f Frame<S>, start: WideVec3<S>, x: i32) -> Self {
        let mut row = Self { frame, start, step: frame.step(), at: start + frame.column(0), x: 0 };
        row.go_to(x);
        row
    }

    /// Goes on to a column without making the rays before it; columns passed are not gone back to.
    pub fn skip_to(&mut self, x: u32) {
        self.go_to(index(x));
    }

    fn go_to(&mut self, x: i32) {
        (self.at, self.x) = self.further(self.at, self.x, x);
    }

    /// Answers the middle of a later column's pixel, and the column.
    ///
    /// Columns are stepped to from their anchor, so that a row begun in its middle has the same bits as the whole
    /// row.
    fn further(&self, mut at: WideVec3<S>, mut x: i32, to: i32) -> (WideVec3<S>, i32) {
        let anchor = to - to % ANCHOR;
        if anchor > x {
            (at, x) = (self.anchor(anchor), anchor);
        }
        while x < to {
            (at, x) = self.after(at, x);
        }
        (at, x)
    }

    fn advance(&mut self) {
        (self.at, self.x) = self.after(self.at, self.x);
    }

    /// Answers the column after one, and where its pixel's middle is.
    fn after(&self, at: WideVec3<S>, x: i32) -> (WideVec3<S>, i32) {
        let x = x.saturating_add(1);
        (if x % ANCHOR == 0 { self.anchor(x) } else { at + self.step }, x)
    }

    /// Answers where the middle of an anchor's pixel is. Called, not inlined: one column of 32 is reached so.
    #[cold]
    #[inline(never)]
    fn anchor(&self, x: i32) -> WideVec3<S> {
        self.start + self.frame.column(x)
    }

    /// Lends the next rays to somebody and goes on behind those that are taken.
    ///
    /// Where the row is meanwhile stays in registers: one that is stepped where it lies is written at every
    /// step, 11 to 13 instructions a ray on an M3 and an M0+.
    pub(crate) fn lend<R>(&mut self, take: impl FnOnce(&mut Going<'_, 'f, S>) -> R) -> R {
        let mut going = Going { row: self, at: self.at, x: self.x };
        let taken = take(&mut going);
        let Going { at, x, .. } = going;
        (self.at, self.x) = (at, x);
        taken
    }

    /// Answers the ray through the middle of the present column's pixel.
    pub fn here(&self) -> RowRay<S> {
        self.ray(self.at)
    }

    /// Answers the ray through a point so far from the middle of the present column's pixel.
    pub fn beside(&self, offset: WideVec3<S>) -> RowRay<S> {
        self.ray(self.at + offset)
    }

    /// Answers the ray through a point of the window, given from the eye.
    fn ray(&self, at: WideVec3<S>) -> RowRay<S> {
        let frame = self.frame;
        let (near, far) = (frame.near, frame.far);
        let offset = at.narrow();
        if frame.parallel {
            let ray = Ray::new(frame.eye + offset, frame.forward);
            return RowRay { ray, interval: Interval::new(near, far), length: S::ONE };
        }
        // The window stands at depth 1: the length of the offset turns depths into distances.
        let (direction, length) = offset.normalize().unwrap_or((frame.forward, S::ONE));
        let interval =
            if frame.clipped { Interval::new(near * length, far * length) } else { Interval::AHEAD };
        RowRay { ray: Ray::new(frame.eye, direction), interval, length }
    }
}

/// Is the iterator over rays that a row has lent.
#[derive(Debug)]
pub(crate) struct Going<'r, 'f, S: Scalar> {
    row: &'r Row<'f, S>,
    at: WideVec3<S>,
    x: i32,
}

impl<S: Scalar> Going<'_, '_, S> {
    /// Goes on to a column, as [`Row::skip_to`] does.
    pub fn skip_to(&mut self, x: u32) {
        (self.at, self.x) = self.row.further(self.at, self.x, index(x));
    }
}

impl<S: Scalar> Iterator for Going<'_, '_, S> {
    type Item = RowRay<S>;

    fn next(&mut self) -> Option<RowRay<S>> {
        let ray = self.row.ray(self.at);
        (self.at, self.x) = self.row.after(self.at, self.x);
        Some(ray)
    }
}

impl<S: Scalar> Iterator for Row<'_, S> {
    type Item = RowRay<S>;

    /// Never ends: a row may be followed past the edge of the picture.
    fn next(&mut self) -> Option<RowRay<S>> {
        let ray = self.here();
        self.advance();
        Some(ray)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Camera;
    use crate::math::{Fixed, Vec3};

    fn check<S: Scalar>(make: fn(f64) -> S) {
        let at = |z: f64| Vec3::new(make(0.0), make(0.3), make(z));
        let camera = Camera::perspective(at(5.0), at(0.0), Vec3::new(S::ZERO, S::ONE, S::ZERO), make(40.0));
        let frame = camera.frame(100, 50).expect("a frame");
        let [mut plain, mut lending] = [frame.row(7, 3), frame.row(7, 3)];
        // Past two anchors, with nothing taken now and then.
        for count in (0..6).cycle().take(30) {
            lending.lend(|rays| assert!(rays.take(count).eq(plain.by_ref().take(count))));
            assert_eq!(lending.here(), plain.here());
        }
        assert!(lending.x > 2 * ANCHOR);
    }

    #[test]
    fn a_row_goes_on_behind_the_rays_that_it_has_lent() {
        check(|x| x as f32);
        check(Fixed::new);
        check(|x| x);
    }
}
