use super::{Intersect, Triangle};
use crate::fault::Fault;
use crate::hit::{Crossing, Surface};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};

/// Is a corner of a [`SmoothTriangle`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex<S = f32> {
    /// Where it is.
    pub point: Vec3<S>,
    /// Outward normal of the curved surface there, of unit length, to the triangle's outward side.
    pub normal: Vec3<S>,
    /// Texture coordinates u and v there.
    pub texture: [S; 2],
}

impl<S> Vertex<S> {
    /// Makes a corner.
    pub const fn new(point: Vec3<S>, normal: Vec3<S>, texture: [S; 2]) -> Self {
        Self { point, normal, texture }
    }
}

/// Is a triangle that is lit as a piece of a curved surface: normals and texture coordinates of its
/// corners are interpolated by barycentric coordinates (Phong 1975; row O6). It is seen from both
/// sides and its outline is that of the [`Triangle`].
///
/// Its corners are the ones of no texture coordinates of their own: with (0, 0), (1, 0) and (0, 1) the
/// interpolated ones are the barycentric ones, as [`Vertices`](crate::texture::Vertices) takes them.
///
/// Where normal and triangle disagree:
/// - A normal that looks away from the viewer, near an outline, is bent until it does not.
/// - A hit's point is where the curved surface would be, mixed of the hit as seen on the tangent planes
///   of the corners (Hanika 2021, in *Ray Tracing Gems II*): from there light and mirror images pass
///   over the edges of a bulging surface, so its shadow begins where its normals turn from the light and
///   not at an edge.
/// - That point lies at least 2^-13 of the triangle's extent on the side it was seen from, so that light
///   from behind meets the triangle itself and is stopped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmoothTriangle<S: 'static = f32> {
    /// Its corners, anticlockwise as seen from outside.
    pub vertices: &'static [Vertex<S>; 3],
}

impl<S> SmoothTriangle<S> {
    /// Makes a triangle of its corners.
    pub const fn new(vertices: &'static [Vertex<S>; 3]) -> Self {
        Self { vertices }
    }
}

impl<S: Scalar> SmoothTriangle<S> {
    fn flat(&self) -> Triangle<S> {
        let [a, b, c] = self.vertices;
        Triangle::new(a.point, b.point, c.point)
    }

    /// Answers how far a hit is put off the triangle.
    fn step(&self) -> S {
        let [a, b, c] = self.vertices;
        let extent = (b.point - a.point).largest().max((c.point - a.point).largest());
        extent * S::SLACK
    }

    /// Answers the interpolated normal on the viewer's side, bent so that the viewer sees that side.
    fn normal(&self, weights: [S; 3], side: S, direction: Vec3<S>) -> Option<Vec3<S>> {
        let normals = self.vertices.iter().map(|vertex| vertex.normal * side);
        let sum =
            normals.zip(weights).fold(Vec3::ZERO, |sum, (normal, weight)| sum.add_scaled(normal, weight));
        let (normal, _) = sum.normalize()?;
        // More than rounding makes of 0: the tracer turns over what looks away.
        let away = normal.dot(direction) + S::SLACK;
        if away <= S::ZERO {
            return Some(normal);
        }
        normal.add_scaled(direction, -away).normalize().map(|(bent, _)| bent)
    }

    /// Answers the point of the curved surface over a point of the triangle, on one side.
    fn bulge(&self, flat: Vec3<S>, weights: [S; 3], side: S) -> Vec3<S> {
        self.vertices.iter().zip(weights).fold(flat, |point, (vertex, weight)| {
            let normal = vertex.normal * side;
            let below = (vertex.point - flat).dot(normal).max(S::ZERO);
            point.add_scaled(normal, below * weight)
        })
    }
}

impl<S: Scalar> Intersect<S> for SmoothTriangle<S> {
    #[inline(never)]
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        self.flat().intersect(ray, interval)
    }

    /// What starts on it starts on one side of it: it may pass through.
    fn intersect_leaving(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        self.intersect(ray, interval)
    }

    #[inline(never)]
    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        let Crossing { u, v, .. } = *crossing;
        let weights = [S::ONE - u - v, u, v];
        let flat = self.flat();
        let outward = flat.normal().unwrap_or(-ray.direction);
        let side = if outward.dot(ray.direction) > S::ZERO { -S::ONE } else { S::ONE };
        let seen = outward * side;
        let point = self.bulge(flat.point(u, v), weights, side).add_scaled(seen, self.step());
        let normal = self.normal(weights, side, ray.direction).unwrap_or(seen) * side;
        let texture = |axis: fn(&Vertex<S>) -> S| {
            let corners = self.vertices.iter().zip(weights);
            corners.fold(S::ZERO, |sum, (vertex, weight)| sum.add_product(axis(vertex), weight))
        };
        Surface { point, normal, u: texture(|v| v.texture[0]), v: texture(|v| v.texture[1]), part: 0 }
    }

    fn hull(&self) -> Hull<S> {
        self.flat().hull()
    }

    fn check(&self) -> Result<(), Fault> {
        self.flat().check()?;
        let outward = self.flat().normal().ok_or(Fault::Degenerate)?;
        for vertex in self.vertices {
            if !(vertex.normal.in_range() && vertex.texture.iter().all(|c| c.in_range())) {
                return Err(Fault::OutOfRange);
            }
            if !vertex.normal.is_unit() {
                return Err(Fault::NoDirection);
            }
            if vertex.normal.dot(outward) <= S::ZERO {
                return Err(Fault::NormalInward);
            }
        }
        Ok(())
    }
}
