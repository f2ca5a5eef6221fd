use super::raster::Image;
use super::roots::{Ray, Root, quadratic};
use super::vector::Vector;
use std::f64::consts::{PI, TAU};

/// Is a ball with a relief.
#[derive(Clone, Debug)]
pub(super) struct Displaced {
    pub center: Vector,
    pub radius: f64,
    pub relief: Image,
    pub height: f64,
}

/// Answers longitude and latitude of a direction as texture coordinates.
pub(super) fn globe_coordinates(direction: Vector) -> [f64; 2] {
    let [x, y, z] = direction.0;
    let phi = z.atan2(x).rem_euclid(TAU);
    let theta = x.hypot(z).atan2(y);
    [1.0 - phi / TAU, 1.0 - theta / PI]
}

/// Answers the derivatives of the unit direction by the texture coordinates.
pub(super) fn globe_derivatives(direction: Vector) -> [Vector; 2] {
    let [x, y, z] = direction.unit().0;
    let (phi, theta) = (z.atan2(x), x.hypot(z).atan2(y));
    let by_phi = Vector([-theta.sin() * phi.sin(), 0.0, theta.sin() * phi.cos()]);
    let by_theta = Vector([theta.cos() * phi.cos(), -theta.sin(), theta.cos() * phi.sin()]);
    [by_phi * -TAU, by_theta * -PI]
}

/// Is how many steps the way through the hull is looked at in: some six times as many as the core's.
const STEPS: u32 = 1200;

impl Displaced {
    fn surface_radius(&self, direction: Vector) -> f64 {
        self.radius + self.height * self.relief.height(globe_coordinates(direction))
    }

    fn above(&self, point: Vector) -> f64 {
        let from_center = point - self.center;
        let distance = from_center.norm();
        // Below the ball all is inside: the relief need not be looked at.
        if distance < self.radius { -1.0 } else { distance - self.surface_radius(from_center) }
    }

    /// Answers all places where the line of a ray goes through the surface.
    ///
    /// Their part is twice their number, and one more where the line comes out: pixels that see through
    /// other folds of the relief have other parts.
    pub fn roots(&self, ray: &Ray) -> Vec<Root> {
        let (v, from) = (ray.direction, ray.start - self.center);
        let hull = self.radius + self.height;
        let ends = quadratic(v.inner(v), 2.0 * from.inner(v), from.inner(from) - hull * hull);
        let [enter, leave] = ends[..] else { return vec![] };
        let at = |step: u32| enter + (leave - enter) * f64::from(step) / f64::from(STEPS);
        let signs: Vec<bool> = (0..=STEPS)
            .map(|step| {
                let rim = step == 0 || step == STEPS;
                rim || self.above(ray.point(at(step))) > 0.0
            })
            .collect();
        let changes = (0..STEPS).filter(|step| signs[*step as usize] != signs[*step as usize + 1]);
        let mut roots: Vec<Root> =
            changes.map(|step| self.root(ray, at(step), at(step + 1), signs[step as usize])).collect();
        let folds = (2 * roots.len()).min(254) as u8;
        roots.iter_mut().for_each(|root| root.part += folds);
        roots
    }

    fn root(&self, ray: &Ray, mut low: f64, mut high: f64, outside: bool) -> Root {
        for _ in 0..60 {
            let middle = (low + high) / 2.0;
            let same = (self.above(ray.point(middle)) > 0.0) == outside;
            if same { low = middle } else { high = middle }
        }
        Root { t: low, part: u8::from(!outside) }
    }

    /// Answers the outward normal at a point: of the surface with its slopes averaged over a texel.
    pub fn normal(&self, point: Vector) -> Vector {
        let direction = (point - self.center).unit();
        let coordinates = globe_coordinates(direction);
        let (radius, rise) = (self.surface_radius(direction), self.relief.rise(coordinates));
        let [by_u, by_v] = globe_derivatives(direction);
        let moved = |rise: f64, turn: Vector| direction * (rise * self.height) + turn * radius;
        let normal = moved(rise[0], by_u).outer(moved(rise[1], by_v));
        normal.unit() * normal.inner(direction).signum()
    }
}
