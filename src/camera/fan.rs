use super::Frame;
use crate::hull::Hull;
use crate::math::{Scalar, Vec3, Wide};
use core::ops::Range;

/// Is a flat fan of rays: those of one row of the picture, or all of its rows seen edge on.
///
/// In the plane of the fan a ray has a slope: how far it goes along the row for a step toward the
/// scene (of parallel rays, where it starts along the row). Slopes grow evenly from column to
/// column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fan<S: Scalar> {
    /// Where the rays start; of parallel ones, a point among their starts.
    pub(crate) apex: Vec3<S>,
    /// Unit vector in which columns lie side by side.
    pub(crate) along: Vec3<S>,
    /// Unit vector across it, toward the scene.
    pub(crate) toward: Vec3<S>,
    /// Unit vector across the fan.
    pub(super) across: Vec3<S>,
    pub(crate) parallel: bool,
    /// Slope at the left edge of the picture, and from there to the right edge.
    pub(crate) start: S,
    pub(crate) extent: S,
    pub(crate) count: i32,
}

/// Is a closed interval of slopes; an end of magnitude [`Scalar::FAR`] is no end.
pub(super) type Slopes<S> = [S; 2];

impl<S: Scalar> Fan<S> {
    /// Answers the columns of a row whose rays can meet what the hull holds: none of them is
    /// missing, a few may be too many.
    pub fn columns(&self, hull: &Hull<S>) -> Range<u16> {
        self.section(hull).map_or(0..0, |slopes| self.range(slopes))
    }

    /// Answers the rows whose rays can meet what the hull holds, where this is the fan of
    /// [`Frame::upright_fan`].
    #[inline(never)]
    pub fn rows(&self, hull: &Hull<S>) -> Range<u16> {
        self.projection(hull).map_or(0..0, |slopes| self.range(slopes))
    }

    /// Answers the pixels whose middles lie between two slopes, and at least half a pixel more on
    /// either side.
    fn range(&self, [low, high]: Slopes<S>) -> Range<u16> {
        let edge = |slope: S| {
            let share = S::div((slope - self.start).mul_wide(S::ONE), self.extent.mul_wide(S::ONE));
            (slope.abs() < S::FAR).then(|| S::floor(share.mul_wide(S::ONE).scale(self.count, 1)))
        };
        let (left, right) = if self.extent > S::ZERO { (low, high) } else { (high, low) };
        let pixel = |x: i32| x.min(self.count).max(0) as u16;
        let first = edge(left).map_or(0, |x| x.saturating_sub(1));
        let end = edge(right).map_or(self.count, |x| x.saturating_add(2));
        pixel(first)..pixel(end)
    }
}

impl<S: Scalar> Frame<S> {
    /// Answers the fan of row `y`; `None` if its rays span no plane.
    pub fn row_fan(&self, y: u32) -> Option<Fan<S>> {
        self.line_fan(y, [1, 2])
    }

    /// Answers the fan of a line of row `y`, given by the fraction of the row's height that lies above it,
    /// numerator and denominator; `None` if its rays span no plane.
    pub fn line_fan(&self, y: u32, above: [u8; 2]) -> Option<Fan<S>> {
        let (along, width) = self.right.narrow().normalize()?;
        let left = self.line_start(y, above).narrow();
        let start = left.dot(along);
        self.fan(along, [start, width], left - along * start, self.size[0])
    }

    /// Answers the fan of all rows: the plane through the eye across every row.
    pub fn upright_fan(&self) -> Option<Fan<S>> {
        let (along, height) = self.down.narrow().normalize()?;
        let start = self.corner.narrow().dot(along);
        let window = if self.parallel { Vec3::ZERO } else { self.forward };
        self.fan(along, [start, height], window, self.size[1])
    }

    /// Makes a fan of its unit vector, where it starts and how long it is on the window, how the
    /// window lies from the eye across that vector, and its number of pixels.
    fn fan(&self, along: Vec3<S>, [start, extent]: [S; 2], window: Vec3<S>, count: i32) -> Option<Fan<S>> {
        let (apex, toward, depth) = if self.parallel {
            (self.eye + window, self.forward, S::ONE)
        } else {
            let (toward, depth) = window.normalize()?;
            (self.eye, toward, depth)
        };
        let slope = |length: S| S::div(length.mul_wide(S::ONE), depth.mul_wide(S::ONE));
        let (parallel, across) = (self.parallel, along.cross(toward));
        Some(Fan { apex, along, toward, across, parallel, start: slope(start), extent: slope(extent), count })
    }
}
