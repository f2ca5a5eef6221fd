//! Rays, and where their lines meet what has an equation.

use super::vector::Vector;

/// Is a half-line; its direction has any length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray {
    pub start: Vector,
    pub direction: Vector,
}

impl Ray {
    /// Answers the point that many directions from the start.
    pub fn point(&self, t: f64) -> Vector {
        self.start + self.direction * t
    }
}

/// Is one place where the endless line of a ray meets a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Root {
    pub t: f64,
    /// The face of a box, the part of a cone, else 0.
    pub part: u8,
}

/// Answers both roots of `a t^2 + b t + c`, the smaller first.
pub(super) fn quadratic(a: f64, b: f64, c: f64) -> Vec<f64> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return vec![];
    }
    let root = discriminant.sqrt();
    vec![(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)]
}

pub(super) fn plane_root(ray: &Ray, point: Vector, normal: Vector) -> Option<f64> {
    let slope = normal.inner(ray.direction);
    (slope != 0.0).then(|| normal.inner(point - ray.start) / slope)
}

/// Answers the shares of a triangle's area that lie across from its three corners.
pub(super) fn shares([a, b, c]: [Vector; 3], point: Vector) -> [f64; 3] {
    let normal = (b - a).outer(c - a);
    let across = |p: Vector, q: Vector| (q - p).outer(point - p).inner(normal) / normal.inner(normal);
    [across(b, c), across(c, a), across(a, b)]
}
