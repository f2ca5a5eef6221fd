use super::description::Shape;
use super::displaced::{globe_coordinates, globe_derivatives};
use super::outline::surrounds;
use super::roots::{Ray, Root, plane_root, quadratic, shares};
use super::vector::Vector;

fn triangle_root(ray: &Ray, corners: [Vector; 3]) -> Option<f64> {
    let [a, b, c] = corners;
    let t = plane_root(ray, a, (b - a).outer(c - a))?;
    shares(corners, ray.point(t)).iter().all(|share| *share >= 0.0).then_some(t)
}

/// Answers where the line passes one face of a box.
fn face_root(ray: &Ray, [low, high]: [Vector; 2], part: u8) -> Option<f64> {
    let axis = usize::from(part / 2);
    let level = if part.is_multiple_of(2) { low.0[axis] } else { high.0[axis] };
    if ray.direction.0[axis] == 0.0 {
        return None;
    }
    let t = (level - ray.start.0[axis]) / ray.direction.0[axis];
    let place = ray.point(t).0;
    let within = |other: usize| low.0[other] <= place[other] && place[other] <= high.0[other];
    (0..3).filter(|other| *other != axis).all(within).then_some(t)
}

impl Shape {
    /// Answers all places where the line of a ray meets the shape, before the start and behind it.
    fn roots(&self, ray: &Ray) -> Vec<Root> {
        let whole = |t: f64| Root { t, part: 0 };
        match *self {
            Self::Displaced(ref ball) => ball.roots(ray),
            Self::Sphere { center, radius } => {
                let (v, from) = (ray.direction, ray.start - center);
                let c = from.inner(from) - radius * radius;
                quadratic(v.inner(v), 2.0 * from.inner(v), c).into_iter().map(whole).collect()
            }
            Self::Plane { point, normal } => plane_root(ray, point, normal).map(whole).into_iter().collect(),
            Self::Triangle { corners } => triangle_root(ray, corners).map(whole).into_iter().collect(),
            Self::Cuboid { low, high } => {
                let face = |part: u8| face_root(ray, [low, high], part).map(|t| Root { t, part });
                (0..6).filter_map(face).collect()
            }
            Self::Polygon { ref vertices, normal, odd_even } => {
                let root = plane_root(ray, vertices[0], normal);
                let held = |t: &f64| surrounds(vertices, normal, odd_even, ray.point(*t));
                root.filter(held).map(whole).into_iter().collect()
            }
            Self::Cone(cone) => cone.roots(ray, None),
            Self::Smooth(triangle) => triangle_root(ray, triangle.points).map(whole).into_iter().collect(),
        }
    }

    /// Answers the roots of a ray that starts on this shape's own `part`, its start left out.
    ///
    /// A flat thing is not met again. A box leaves out the faces in the plane of the start. Of a
    /// ball's two roots one is the start, up to rounding: the one nearer to 0.
    fn roots_leaving(&self, ray: &Ray, part: u8) -> Vec<Root> {
        let mut roots = self.roots(ray);
        match *self {
            // The start is the nearest root, unless rounding has put it beside the surface.
            Self::Displaced(_) => roots.retain(|root| root.t.abs() * ray.direction.norm() > 1e-7),
            Self::Sphere { .. } => {
                roots.sort_by(|a, b| b.t.abs().total_cmp(&a.t.abs()));
                roots.truncate(1);
            }
            Self::Plane { .. } | Self::Triangle { .. } | Self::Polygon { .. } => roots.clear(),
            Self::Cuboid { low, high } => {
                let axis = usize::from(part / 2);
                let flat = low.0[axis] == high.0[axis];
                roots.retain(|root| root.part != part && !(flat && root.part / 2 == part / 2));
            }
            Self::Cone(cone) => roots = cone.roots(ray, Some(part)),
            // Its light starts beside it.
            Self::Smooth(_) => (),
        }
        roots
    }

    /// Answers where a ray meets the shape ahead; `left` is the part it starts on, if any.
    pub fn roots_ahead(&self, ray: &Ray, left: Option<u8>) -> Vec<Root> {
        let mut roots = match left {
            Some(part) => self.roots_leaving(ray, part),
            None => self.roots(ray),
        };
        roots.retain(|root| root.t > 0.0);
        roots
    }

    /// Answers a unit normal at a point of a part, outward where there is an outside.
    pub fn normal(&self, point: Vector, part: u8) -> Vector {
        match *self {
            Self::Displaced(ref ball) => ball.normal(point),
            Self::Sphere { center, .. } => (point - center).unit(),
            Self::Plane { normal, .. } | Self::Polygon { normal, .. } => normal.unit(),
            Self::Triangle { corners: [a, b, c] } => (b - a).outer(c - a).unit(),
            Self::Cuboid { .. } => {
                let outward = if part.is_multiple_of(2) { -1.0 } else { 1.0 };
                Vector::by_axis(|axis| if axis == usize::from(part / 2) { outward } else { 0.0 })
            }
            Self::Cone(cone) => cone.normal(point, part),
            Self::Smooth(triangle) => triangle.flat_normal(),
        }
    }

    /// Answers where the light is that a ray finds at a point, and the unit normal there on the viewer's
    /// side.
    pub fn lit(&self, ray: &Ray, point: Vector, part: u8) -> (Vector, Vector) {
        if let Self::Smooth(triangle) = self {
            return triangle.lit(ray, point);
        }
        let outward = self.normal(point, part);
        if let Self::Displaced(_) = self {
            // The part tells the side; an averaged normal may look away from it.
            let normal = if part.is_multiple_of(2) { outward } else { -outward };
            return (point, normal.turned_to(-ray.direction.unit()));
        }
        (point, if outward.inner(ray.direction) > 0.0 { -outward } else { outward })
    }

    /// Answers the derivatives of the point by the texture coordinates; `lit` is the normal that light sees.
    pub fn derivatives(&self, point: Vector, part: u8, lit: Vector) -> [Vector; 2] {
        let along = |axis: usize, length: f64| Vector::by_axis(|i| if i == axis { length } else { 0.0 });
        match *self {
            Self::Displaced(ref ball) => {
                let from_center = point - ball.center;
                globe_derivatives(from_center).map(|derivative| derivative * from_center.norm())
            }
            Self::Sphere { center, radius } => {
                globe_derivatives(point - center).map(|derivative| derivative * radius)
            }
            Self::Triangle { corners: [a, b, c] } => [b - a, c - a],
            Self::Cone(cone) => cone.derivatives(point, part),
            Self::Smooth(triangle) => triangle.derivatives(lit),
            Self::Cuboid { low, high } => {
                others(usize::from(part / 2)).map(|axis| along(axis, high.0[axis] - low.0[axis]))
            }
            Self::Plane { .. } | Self::Polygon { .. } => {
                let normal = self.normal(point, part);
                let hidden = largest_axis(normal);
                others(hidden).map(|axis| along(axis, 1.0) - along(hidden, normal.0[axis] / normal.0[hidden]))
            }
        }
    }

    /// Answers the texture coordinates of a point of a part.
    pub fn texture_coordinates(&self, point: Vector, part: u8) -> [f64; 2] {
        match *self {
            Self::Displaced(ref ball) => globe_coordinates(point - ball.center),
            Self::Sphere { center, .. } => globe_coordinates(point - center),
            Self::Plane { normal, .. } | Self::Polygon { normal, .. } => {
                leave_out(largest_axis(normal), point)
            }
            Self::Triangle { corners } => {
                let [_, u, v] = shares(corners, point);
                [u, v]
            }
            Self::Cuboid { low, high } => {
                let share = |axis| (point.0[axis] - low.0[axis]) / (high.0[axis] - low.0[axis]);
                leave_out(usize::from(part / 2), Vector::by_axis(share))
            }
            Self::Cone(cone) => cone.texture_coordinates(point),
            Self::Smooth(triangle) => triangle.texture_coordinates(point),
        }
    }
}

/// Answers the axis along which a vector is longest; of equals the second, then the first.
fn largest_axis(v: Vector) -> usize {
    let size = v.0.map(f64::abs);
    let longest = size[0].max(size[1]).max(size[2]);
    [1, 0, 2].into_iter().find(|axis| size[*axis] == longest).unwrap_or(1)
}

/// Answers the two axes other than one.
fn others(axis: usize) -> [usize; 2] {
    [[1, 2], [0, 2], [0, 1]][axis]
}

/// Answers the two components other than that of an axis.
fn leave_out(axis: usize, v: Vector) -> [f64; 2] {
    others(axis).map(|other| v.0[other])
}
