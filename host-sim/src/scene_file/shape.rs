//! Shapes of a scene file.
//!
//! To add one: a variant, and an arm in each of the two functions; the compiler asks for the arms.

use super::grid::{Grid, Isosurface};
use super::image::{Image, ImageFile};
use super::mesh::Mesh;
use super::value::{Point, point, unless};
use crate::rounded::Rounded;
use scanray::{Cone, Cuboid, Displaced, Plane, Polygon, SmoothTriangle, Sphere, Triangle};
use serde::{Deserialize, Serialize};

/// Is a shape; its fields are those of the core's shape of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Shape {
    /// A ball.
    Sphere {
        /// Middle of the ball.
        center: Point,
        /// Distance of the surface from it, above 0.
        radius: f64,
    },
    /// An endless plane.
    Plane {
        /// Any point of the plane.
        point: Point,
        /// A vector across it, of any length but zero.
        normal: Point,
    },
    /// A triangle, seen from both sides.
    Triangle {
        /// First corner.
        a: Point,
        /// Second corner.
        b: Point,
        /// Third corner.
        c: Point,
    },
    /// A box along the axes.
    Cuboid {
        /// Corner with the lowest coordinates.
        low: Point,
        /// Corner with the highest coordinates.
        high: Point,
    },
    /// A flat polygon of any outline, seen from both sides.
    Polygon {
        /// Corners of the outline in order, at least three.
        vertices: Vec<Point>,
        /// A vector across the plane, of any length but zero.
        normal: Point,
        /// What of a self-crossing outline is inside.
        rule: FillRule,
    },
    /// A cone or a cylinder, whole or cut off.
    Cone {
        /// Middle of one end.
        base: Point,
        /// Radius there, at least 0.
        base_radius: f64,
        /// Middle of the other end.
        apex: Point,
        /// Radius there, at least 0.
        apex_radius: f64,
        /// Whether discs close the ends; by default they do.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        capped: Option<bool>,
    },
    /// A triangle lit as a piece of a curved surface.
    SmoothTriangle {
        /// First corner.
        a: Vertex,
        /// Second corner.
        b: Vertex,
        /// Third corner.
        c: Vertex,
    },
    /// A ball whose points a map of heights moves outward.
    Displaced {
        /// Middle of the ball.
        center: Point,
        /// Distance of the surface from it where the map is black, above 0.
        radius: f64,
        /// The map: black is 0, green at its full level `height`.
        relief: Image,
        /// How far the highest points are moved, at least 0.
        height: f64,
    },
    /// Triangles of a file that share their corners.
    Mesh(Mesh),
    /// The surface in a sampled field.
    Isosurface(Isosurface),
}

/// Names what of a self-crossing outline is inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum FillRule {
    /// What a half-line leaves by an odd number of crossings.
    OddEven,
    /// What the outline runs around more often one way than the other.
    Winding,
}

/// Is a corner of a smooth triangle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Vertex {
    /// Where it is.
    pub point: Point,
    /// Outward normal of the curved surface there, of unit length.
    pub normal: Point,
    /// Texture coordinates there.
    pub texture: [f64; 2],
}

impl FillRule {
    fn in_core(self) -> scanray::FillRule {
        match self {
            Self::OddEven => scanray::FillRule::OddEven,
            Self::Winding => scanray::FillRule::Winding,
        }
    }

    fn of(rule: scanray::FillRule) -> Self {
        match rule {
            scanray::FillRule::OddEven => Self::OddEven,
            scanray::FillRule::Winding => Self::Winding,
        }
    }
}

impl Vertex {
    fn in_number<S: Rounded>(&self) -> scanray::Vertex<S> {
        scanray::Vertex::new(point(self.point), point(self.normal), self.texture.map(S::round))
    }

    fn of(vertex: &scanray::Vertex<f64>) -> Self {
        let scanray::Vertex { point, normal, texture } = *vertex;
        Self { point: point.to_array(), normal: normal.to_array(), texture }
    }
}

impl Shape {
    /// Makes the core's shape, rounded to a number.
    ///
    /// Corners that the core's shape borrows stay in memory as long as the program runs.
    pub fn in_number<S: Rounded>(&self) -> scanray::Shape<S> {
        match *self {
            Self::Sphere { center, radius } => {
                scanray::Shape::Sphere(Sphere::new(point(center), S::round(radius)))
            }
            Self::Plane { point: of, normal } => scanray::Shape::Plane(Plane::new(point(of), point(normal))),
            Self::Triangle { a, b, c } => {
                scanray::Shape::Triangle(Triangle::new(point(a), point(b), point(c)))
            }
            Self::Cuboid { low, high } => scanray::Shape::Cuboid(Cuboid::new(point(low), point(high))),
            Self::Polygon { ref vertices, normal, rule } => {
                let vertices = Vec::leak(vertices.iter().map(|corner| point(*corner)).collect());
                scanray::Shape::Polygon(Polygon::new(vertices, point(normal), rule.in_core()))
            }
            Self::Cone { base, base_radius, apex, apex_radius, capped } => {
                let [base_radius, apex_radius] = [base_radius, apex_radius].map(S::round);
                let cone = Cone::new(point(base), base_radius, point(apex), apex_radius);
                scanray::Shape::Cone(Cone { capped: capped.unwrap_or(cone.capped), ..cone })
            }
            Self::SmoothTriangle { ref a, ref b, ref c } => {
                let vertices = Box::leak(Box::new([a, b, c].map(Vertex::in_number)));
                scanray::Shape::SmoothTriangle(SmoothTriangle::new(vertices))
            }
            Self::Displaced { center, radius, ref relief, height } => {
                let ball = Sphere::new(point(center), S::round(radius));
                scanray::Shape::Displaced(Displaced::new(ball, relief.in_number(), S::round(height)))
            }
            Self::Mesh(ref mesh) => scanray::Shape::Mesh(mesh.in_number()),
            Self::Isosurface(ref surface) => scanray::Shape::Isosurface(surface.in_number()),
        }
    }

    /// Answers its image, if it has one, with a word for what it is for.
    pub fn image_mut(&mut self) -> Option<(&'static str, &mut ImageFile)> {
        if let Self::Displaced { relief, .. } = self { Some(("relief", &mut relief.file)) } else { None }
    }

    /// Answers it, if it is a mesh.
    pub fn mesh_mut(&mut self) -> Option<&mut Mesh> {
        if let Self::Mesh(mesh) = self { Some(mesh) } else { None }
    }

    /// Answers its grid of voxels, if it has one.
    pub fn grid_mut(&mut self) -> Option<&mut Grid> {
        if let Self::Isosurface(surface) = self { Some(&mut surface.grid) } else { None }
    }

    /// Takes a shape of the core; `None` for one that scene files do not know.
    pub fn of(shape: &scanray::Shape<f64>) -> Option<Self> {
        Some(match shape {
            scanray::Shape::Sphere(s) => Self::Sphere { center: s.center.to_array(), radius: s.radius },
            scanray::Shape::Plane(s) => {
                Self::Plane { point: s.point.to_array(), normal: s.normal.to_array() }
            }
            scanray::Shape::Triangle(s) => {
                Self::Triangle { a: s.a.to_array(), b: s.b.to_array(), c: s.c.to_array() }
            }
            scanray::Shape::Cuboid(s) => Self::Cuboid { low: s.low.to_array(), high: s.high.to_array() },
            scanray::Shape::Polygon(s) => Self::Polygon {
                vertices: s.vertices.iter().map(|corner| corner.to_array()).collect(),
                normal: s.normal.to_array(),
                rule: FillRule::of(s.rule),
            },
            scanray::Shape::Cone(s) => Self::Cone {
                base: s.base.to_array(),
                base_radius: s.base_radius,
                apex: s.apex.to_array(),
                apex_radius: s.apex_radius,
                capped: unless(true, s.capped),
            },
            scanray::Shape::SmoothTriangle(s) => {
                let [a, b, c] = s.vertices.each_ref().map(Vertex::of);
                Self::SmoothTriangle { a, b, c }
            }
            scanray::Shape::Displaced(s) => Self::Displaced {
                center: s.ball.center.to_array(),
                radius: s.ball.radius,
                relief: Image::of(&s.relief),
                height: s.height,
            },
            scanray::Shape::Mesh(mesh) => Self::Mesh(Mesh::of(mesh)?),
            scanray::Shape::Isosurface(surface) => Self::Isosurface(Isosurface::of(surface)),
            scanray::Shape::Custom(none) => match *none {},
        })
    }
}
