use super::called::{add_scaled, difference, dot, normalized, product, scaled};
use super::{Intersect, Triangle};
use crate::fault::Fault;
use crate::hit::{Crossing, Surface, Tangent};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3, Wide};
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
/// Corners without texture coordinates of their own take (0, 0), (1, 0) and (0, 1): between them these are
/// the barycentric coordinates, by which [`Vertices`](crate::texture::Vertices) mixes colours.
///
/// Where normal and triangle disagree:
/// - A normal that looks away from the viewer, near an outline, is bent until it does not.
/// - A hit's point is where the curved surface would be, mixed of the hit as seen on the tangent planes
///   of the corners (Hanika 2021, in *Ray Tracing Gems II*): from there light and mirror images pass
///   over the edges of a bulging surface, so its shadow begins where its normals turn from the light and
///   not at an edge.
/// - That point lies on the side it was seen from, at least 2^-13 off of the largest difference of a
///   coordinate between the corners a and b or c, so that light from behind meets the triangle itself and
///   is stopped.
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

/// Is a smooth triangle, its corners put together from wherever they lie.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet<S> {
    /// Its corners, anticlockwise as seen from outside.
    pub vertices: [Vertex<S>; 3],
}

impl<S> Facet<S> {
    /// Makes a triangle of its corners.
    pub const fn new(vertices: [Vertex<S>; 3]) -> Self {
        Self { vertices }
    }
}

impl<S: Scalar> SmoothTriangle<S> {
    fn flat(&self) -> Triangle<S> {
        let [a, b, c] = self.vertices;
        Triangle::new(a.point, b.point, c.point)
    }
}

impl<S: Scalar> Facet<S> {
    fn flat(&self) -> Triangle<S> {
        let [a, b, c] = &self.vertices;
        Triangle::new(a.point, b.point, c.point)
    }

    /// Answers the derivatives of the point by the texture coordinates over the triangle; `None` where the
    /// corners' coordinates lie on a line.
    ///
    /// With edges e, f and the coordinates' differences (du1, dv1), (du2, dv2) along them, these are
    /// `(e dv2 - f dv1) / D` and `(f du1 - e du2) / D`, `D = du1 dv2 - du2 dv1`.
    fn derivatives(&self) -> Option<[Vec3<S>; 2]> {
        let [a, b, c] = self.vertices;
        let [e, f] = [b, c].map(|corner| difference(corner.point, a.point));
        let [[du1, dv1], [du2, dv2]] =
            [b, c].map(|corner| [corner.texture[0] - a.texture[0], corner.texture[1] - a.texture[1]]);
        let divisor = product(du1, dv2) - product(du2, dv1);
        if divisor == S::Wide::ZERO {
            return None;
        }
        // All digits are kept until the one division: coordinates of a large mesh differ by little.
        let over = |p: S, g: S, q: S, h: S| S::div(product(p, g) - product(q, h), divisor);
        let mix = |p: Vec3<S>, g: S, q: Vec3<S>, h: S| {
            Vec3::new(over(p.x, g, q.x, h), over(p.y, g, q.y, h), over(p.z, g, q.z, h))
        };
        Some([mix(e, dv2, f, dv1), mix(f, du1, e, du2)])
    }

    /// Answers how far a hit is put off the triangle.
    fn step(&self) -> S {
        let [a, b, c] = &self.vertices;
        let reach = |corner: &Vertex<S>| difference(corner.point, a.point).largest();
        let extent = reach(b).max(reach(c));
        extent * S::SLACK
    }

    /// Answers the interpolated normal on the viewer's side, bent so that the viewer sees that side.
    fn normal(&self, weights: [S; 3], side: S, direction: Vec3<S>) -> Option<Vec3<S>> {
        let normals = self.vertices.iter().map(|vertex| scaled(vertex.normal, side));
        let sum =
            normals.zip(weights).fold(Vec3::ZERO, |sum, (normal, weight)| add_scaled(sum, normal, weight));
        let (normal, _) = normalized(sum)?;
        // More than rounding makes of 0: the tracer turns over what looks away.
        let away = dot(normal, direction) + S::SLACK;
        if away <= S::ZERO {
            return Some(normal);
        }
        normalized(add_scaled(normal, direction, -away)).map(|(bent, _)| bent)
    }

    /// Answers the point of the curved surface over a point of the triangle, on one side.
    fn bulge(&self, flat: Vec3<S>, weights: [S; 3], side: S) -> Vec3<S> {
        self.vertices.iter().zip(weights).fold(flat, |point, (vertex, weight)| {
            let normal = scaled(vertex.normal, side);
            let below = dot(difference(vertex.point, flat), normal).max(S::ZERO);
            add_scaled(point, normal, below * weight)
        })
    }

    /// Works out the surface at a crossing of its triangle.
    #[inline(never)]
    pub(super) fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        let Crossing { u, v, .. } = *crossing;
        let weights = [S::ONE - u - v, u, v];
        let flat = self.flat();
        let outward = flat.normal().unwrap_or(-ray.direction);
        let side = if dot(outward, ray.direction) > S::ZERO { -S::ONE } else { S::ONE };
        let seen = scaled(outward, side);
        let point = add_scaled(self.bulge(flat.point(u, v), weights, side), seen, self.step());
        let normal = scaled(self.normal(weights, side, ray.direction).unwrap_or(seen), side);
        let texture = |axis: fn(&Vertex<S>) -> S| {
            let corners = self.vertices.iter().zip(weights);
            corners.fold(S::ZERO, |sum, (vertex, weight)| sum.add_product(axis(vertex), weight))
        };
        Surface { point, normal, u: texture(|v| v.texture[0]), v: texture(|v| v.texture[1]), part: 0 }
    }

    /// Answers the ways along which the texture coordinates grow.
    pub(super) fn tangents(&self, surface: &Surface<S>) -> [Tangent<S>; 2] {
        let onto = |along: Vec3<S>| add_scaled(along, surface.normal, -dot(along, surface.normal));
        let derivatives = self.derivatives().unwrap_or([Vec3::ZERO; 2]);
        derivatives.map(|along| Tangent::along(onto(along)))
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
        Facet::new(*self.vertices).surface(ray, crossing)
    }

    /// Along the triangle as its corners' coordinates grow, laid onto the curved surface: across the
    /// interpolated normal. Where the corners' coordinates lie on a line there are no bumps; in fixed
    /// point they come out too steep where a unit of a coordinate is longer than 2048.
    #[inline(never)]
    fn tangents(&self, surface: &Surface<S>) -> [Tangent<S>; 2] {
        Facet::new(*self.vertices).tangents(surface)
    }

    #[inline(never)]
    fn hull(&self) -> Hull<S> {
        self.flat().hull()
    }

    #[inline(never)]
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
