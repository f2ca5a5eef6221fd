use super::{Intersect, Plane, Triangle};
use crate::aabb::Aabb;
use crate::fault::Fault;
use crate::hit::{Crossing, Surface};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3, Wide};
use crate::ray::{Interval, Ray};

/// Names the rule that says what an outline that crosses itself surrounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FillRule {
    /// Odd-even: a half-line from the point crosses the outline an odd number of times.
    OddEven,
    /// Winding number: the outline runs around the point more often one way than the other.
    Winding,
}

/// Is a flat polygon, seen from both sides: the points of a plane that a closed outline surrounds,
/// be it concave or crossing itself.
///
/// The ray meets the plane as in [`Plane`], whose texture coordinates it has. Whether the outline
/// surrounds it is decided as seen along the ray, by the edges that cross a half-line across it:
/// their number says it by the odd-even rule, and upward ones less downward ones by the winding
/// number (Hormann and Agathos 2001; row O4). A corner on the half-line counts as below it, and an
/// edge is judged from its lower end, whichever way it runs: polygons that share an edge leave no
/// gap between them and do not overlap.
///
/// In fixed point a corner may lie as far as 1448 from where a ray starts, on each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon<S: 'static = f32> {
    /// Corners of the outline in order, at least three; the last is joined to the first.
    pub vertices: &'static [Vec3<S>],
    /// A vector across the plane, of any length but zero.
    pub normal: Vec3<S>,
    /// What of a self-crossing outline is inside.
    pub rule: FillRule,
}

impl<S> Polygon<S> {
    /// Makes a polygon of its corners, a vector of any length across them, and a rule.
    pub const fn new(vertices: &'static [Vec3<S>], normal: Vec3<S>, rule: FillRule) -> Self {
        Self { vertices, normal, rule }
    }
}

impl<S: Scalar> Polygon<S> {
    /// Is how many times larger than what a corner may miss its plane by a polygon's extent is:
    /// where it fills a picture, that is less than a pixel.
    const FLAT: i32 = 1 << 10;

    /// Answers a vector across the best plane of some corners, its largest component 1, by the sum of
    /// vector products along the outline (Newell; in Sutherland, Sproull and Schumacker 1974).
    ///
    /// It points to where the outline runs anticlockwise. `None` where as much area is run around one
    /// way as the other: of a bow tie, or of corners on a line. In fixed point the area may be
    /// 2^22, that of a square of 2048.
    pub fn newell(vertices: &[Vec3<S>]) -> Option<Vec3<S>> {
        let (first, rest) = vertices.split_first()?;
        let mut sum = [S::Wide::ZERO; 3];
        for (a, b) in rest.iter().zip(rest.iter().skip(1)) {
            // From the first corner, so that small polygons far from the origin keep their digits.
            let (a, b) = (*a - *first, *b - *first);
            let areas = [[a.y, a.z, b.y, b.z], [a.z, a.x, b.z, b.x], [a.x, a.y, b.x, b.y]];
            for (sum, [p, q, r, s]) in sum.iter_mut().zip(areas) {
                *sum = *sum + p.mul_wide(s) - q.mul_wide(r);
            }
        }
        let longest = sum.iter().fold(S::Wide::ZERO, |most, c| if c.abs() > most { c.abs() } else { most });
        (longest > S::Wide::ZERO).then(|| Vec3::from_array(sum.map(|c| S::div(c, longest))))
    }

    fn plane(&self) -> Plane<S> {
        Plane::new(self.first(), self.normal)
    }

    fn first(&self) -> Vec3<S> {
        self.vertices.first().copied().unwrap_or(Vec3::ZERO)
    }

    /// Tells whether the outline surrounds the line of a ray.
    fn surrounds(&self, ray: &Ray<S>) -> bool {
        let Some(last) = self.vertices.last() else { return false };
        let sight = Sight::along(ray);
        let mut from = sight.place(*last);
        let mut turns = 0_i32;
        for vertex in self.vertices {
            let to = sight.place(*vertex);
            turns = turns.wrapping_add(turn(from, to));
            from = to;
        }
        match self.rule {
            // As many edges cross as there are turns, or an even number more.
            FillRule::OddEven => turns & 1 == 1,
            FillRule::Winding => turns != 0,
        }
    }

    fn has_area(&self) -> bool {
        let pairs = self.vertices.iter().zip(self.vertices.iter().skip(1));
        pairs.into_iter().any(|(a, b)| Triangle::new(self.first(), *a, *b).normal().is_some())
    }

    fn is_flat(&self, normal: Vec3<S>) -> bool {
        let Vec3 { x, y, z } = Aabb::around(self.vertices).half;
        let half = x.max(y).max(z);
        let tolerance = S::narrow((half + half).mul_wide(S::ONE).scale(1, Self::FLAT));
        self.vertices.iter().all(|vertex| (*vertex - self.first()).dot(normal).abs() <= tolerance)
    }
}

/// Is how points are seen along a ray: dropped onto the two axes it runs least along.
struct Sight<S> {
    origin: Vec3<S>,
    /// The ray's direction, the axis it runs most along last.
    direction: [S; 3],
    order: Order,
}

/// Names the axis that comes last when axes are turned around in a circle.
#[derive(Clone, Copy)]
enum Order {
    X,
    Y,
    Z,
}

impl Order {
    fn of<S: Scalar>(self, v: Vec3<S>) -> [S; 3] {
        match self {
            Self::X => [v.y, v.z, v.x],
            Self::Y => [v.z, v.x, v.y],
            Self::Z => [v.x, v.y, v.z],
        }
    }
}

impl<S: Scalar> Sight<S> {
    fn along(ray: &Ray<S>) -> Self {
        let [x, y, z] = ray.direction.to_array().map(S::abs);
        let order = if x >= y && x >= z {
            Order::X
        } else if y >= z {
            Order::Y
        } else {
            Order::Z
        };
        Self { origin: ray.origin, direction: order.of(ray.direction), order }
    }

    /// Answers where a point is seen, the ray at the origin; without a division, so scaled by the
    /// direction's largest component.
    fn place(&self, point: Vec3<S>) -> [S; 2] {
        let [p, q, depth] = self.order.of(point - self.origin);
        let [along_p, along_q, along] = self.direction;
        [S::determinant([p, along_p], [depth, along]), S::determinant([q, along_q], [depth, along])]
    }
}

/// Answers 1 for an edge that crosses the half-line from the origin to the right upward, -1 for one
/// that crosses it downward, 0 for others.
fn turn<S: Scalar>(from: [S; 2], to: [S; 2]) -> i32 {
    let upward = to[1] > S::ZERO;
    if upward == (from[1] > S::ZERO) {
        return 0;
    }
    let (low, high, turn) = if upward { (from, to, 1) } else { (to, from, -1) };
    // From the lower end, so that both polygons beside an edge get the same answer.
    if low[0].mul_wide(high[1]) > low[1].mul_wide(high[0]) { turn } else { 0 }
}

impl<S: Scalar> Intersect<S> for Polygon<S> {
    #[inline(never)]
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let crossing = self.plane().intersect(ray, interval)?;
        self.surrounds(ray).then_some(crossing)
    }

    /// A ray that starts on a polygon never meets it again.
    fn intersect_leaving(&self, _: &Ray<S>, _: &Interval<S>) -> Option<Crossing<S>> {
        None
    }

    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        self.plane().surface(ray, crossing)
    }

    /// Whatever its outline: it is flat.
    fn is_convex(&self) -> bool {
        true
    }

    fn hull(&self) -> Hull<S> {
        Hull::Box(Aabb::around(self.vertices))
    }

    fn check(&self) -> Result<(), Fault> {
        if self.vertices.len() < 3 {
            return Err(Fault::TooFewCorners);
        }
        if !(self.normal.in_range() && self.vertices.iter().all(|vertex| vertex.in_range())) {
            return Err(Fault::OutOfRange);
        }
        let (normal, _) = self.normal.normalize().ok_or(Fault::NoDirection)?;
        if !self.has_area() {
            Err(Fault::Degenerate)
        } else if !self.is_flat(normal) {
            Err(Fault::NotFlat)
        } else {
            Ok(())
        }
    }
}
