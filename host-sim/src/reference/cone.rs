use super::roots::{Ray, Root, plane_root, quadratic};
use super::vector::Vector;
use std::f64::consts::TAU;

/// Is a cone between two discs across the way from one to the other; a disc may be a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cone {
    pub ends: [Vector; 2],
    pub radii: [f64; 2],
    pub capped: bool,
}

impl Cone {
    const SIDE: u8 = 0;
    const FIRST_CAP: u8 = 1;

    fn axis(&self) -> Vector {
        self.ends[1] - self.ends[0]
    }

    /// Answers a vector's share of the way from end to end.
    fn share(&self, v: Vector) -> f64 {
        v.inner(self.axis()) / self.axis().inner(self.axis())
    }

    /// Answers all places where the line of a ray meets the endless double cone of the side:
    /// `|p - s V|^2 = (r0 + (r1 - r0) s)^2` where p comes from the first end and s is its share of
    /// the way V to the second.
    fn side_roots(&self, ray: &Ray) -> Vec<f64> {
        let from = ray.start - self.ends[0];
        let (s0, s1) = (self.share(from), self.share(ray.direction));
        let (p0, p1) = (from - self.axis() * s0, ray.direction - self.axis() * s1);
        let growth = self.radii[1] - self.radii[0];
        let (r0, r1) = (self.radii[0] + growth * s0, growth * s1);
        let (a, b, c) = (p1.inner(p1) - r1 * r1, 2.0 * (p0.inner(p1) - r0 * r1), p0.inner(p0) - r0 * r0);
        if a == 0.0 { vec![-c / b] } else { quadratic(a, b, c) }
    }

    fn is_between_ends(&self, point: Vector) -> bool {
        (0.0..=1.0).contains(&self.share(point - self.ends[0]))
    }

    /// Answers where the line passes the caps.
    fn cap_roots(&self, ray: &Ray) -> Vec<Root> {
        let cap = |end: usize| {
            let t = plane_root(ray, self.ends[end], self.axis())?;
            let within = (ray.point(t) - self.ends[end]).norm() <= self.radii[end];
            (self.capped && within).then_some(Root { t, part: Self::FIRST_CAP + end as u8 })
        };
        (0..2).filter_map(cap).collect()
    }

    /// Answers all places where the line of a ray meets the cone; `left` is the part it starts on,
    /// whose root at the start is left out.
    pub fn roots(&self, ray: &Ray, left: Option<u8>) -> Vec<Root> {
        let mut sides = self.side_roots(ray);
        if left == Some(Self::SIDE) {
            sides.sort_by(|a, b| b.abs().total_cmp(&a.abs()));
            sides.pop();
        }
        sides.retain(|t| self.is_between_ends(ray.point(*t)));
        let mut roots = self.cap_roots(ray);
        roots.retain(|root| Some(root.part) != left);
        roots.extend(sides.into_iter().map(|t| Root { t, part: Self::SIDE }));
        roots
    }

    /// Answers the outward unit normal at a point of a part: of the side the gradient of its equation.
    pub fn normal(&self, point: Vector, part: u8) -> Vector {
        if part != Self::SIDE {
            return self.axis().unit() * if part == Self::FIRST_CAP { -1.0 } else { 1.0 };
        }
        let from = point - self.ends[0];
        let outward = (from - self.axis() * self.share(from)).unit();
        let growth = (self.radii[1] - self.radii[0]) / self.axis().inner(self.axis());
        (outward - self.axis() * growth).unit()
    }

    /// Answers two unit vectors across the axis, a quarter of a turn apart: the first is the world's x
    /// without its share along the axis, or y where the axis is longest along x.
    fn dial(&self) -> [Vector; 2] {
        let [x, y, z] = self.axis().0.map(f64::abs);
        let first = usize::from(x > y.max(z));
        let unit = Vector::by_axis(|axis| if axis == first { 1.0 } else { 0.0 });
        let across = (unit - self.axis() * self.share(unit)).unit();
        [across, across.outer(self.axis().unit())]
    }

    /// Answers the angle of a point on the dial, from 0 to 2 pi.
    fn angle(&self, point: Vector) -> f64 {
        let [x, z] = self.dial().map(|unit| unit.inner(point - self.ends[0]));
        z.atan2(x).rem_euclid(TAU)
    }

    /// Answers the texture coordinates of a point.
    pub fn texture_coordinates(&self, point: Vector) -> [f64; 2] {
        let share = self.share(point - self.ends[0]).clamp(0.0, 1.0 - f64::EPSILON);
        [1.0 - self.angle(point) / TAU, share]
    }

    /// Answers the derivatives of the side's points `base + V v + (r0 + (r1 - r0) v) (X cos a + Z sin a)`,
    /// `a = 2 pi (1 - u)`, by u and v; of a cap's points by v it is 0.
    pub fn derivatives(&self, point: Vector, part: u8) -> [Vector; 2] {
        let ([x, z], angle) = (self.dial(), self.angle(point));
        let [r0, r1] = self.radii;
        let radius = r0 + (r1 - r0) * self.share(point - self.ends[0]);
        let by_u = (x * -angle.sin() + z * angle.cos()) * (-TAU * radius);
        let by_v = self.axis() + (x * angle.cos() + z * angle.sin()) * (r1 - r0);
        [by_u, if part == Self::SIDE { by_v } else { Vector::default() }]
    }
}
