//! A scene as the format has it, entity by entity.

use crate::scene_file::value::Point;

/// Is all that a file says, in its own units and order.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Entity `v`: where it is seen from.
    pub view: View,
    /// Entity `b`: what rays see that meet nothing, red, green and blue; black if not given.
    pub background: [f64; 3],
    /// Entities `l`: where light comes from.
    pub lights: Vec<Light>,
    /// Entities `f`: what the objects after them are made of.
    pub fills: Vec<Fill>,
    /// Entities `c`, `s`, `p` and `pp`: what there is to see.
    pub objects: Vec<Object>,
}

/// Is a viewpoint.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// The eye.
    pub from: Point,
    /// What is in the middle of the picture.
    pub at: Point,
    /// Which way is up, of any length but zero.
    pub up: Point,
    /// Degrees from the centres of the top row's pixels to those of the bottom row's, above 0 and below 180.
    pub angle: f64,
    /// Distance of the plane before which nothing is seen.
    pub hither: f64,
    /// Columns and rows.
    pub resolution: [u32; 2],
}

/// Is a light at a point, the same at any distance.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Where it is.
    pub position: Point,
    /// Its red, green and blue; if not given, what suits the number of lights.
    pub color: Option<[f64; 3]>,
}

/// Is what a surface does with light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fill {
    /// Red, green and blue from 0 to 1.
    pub color: [f64; 3],
    /// Kd, the diffuse component, at least 0.
    pub diffuse: f64,
    /// Ks, the specular component, at least 0.
    pub specular: f64,
    /// Phong's cosine power for highlights, at least 0.
    pub shine: f64,
    /// T, the fraction of the contribution of the transmitted ray, from 0 to 1.
    pub transmittance: f64,
    /// Index of refraction; means nothing where no light comes through.
    pub index: f64,
}

/// Is a shape with the place of its fill in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// The surface.
    pub shape: Shape,
    /// Index into [`Scene::fills`].
    pub fill: usize,
}

/// Is a surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A cone or cylinder without ends.
    Cone {
        /// Middles of base and apex.
        ends: [Point; 2],
        /// Radii there; negative ones show the inside only.
        radii: [f64; 2],
    },
    /// A ball.
    Sphere {
        /// Its middle.
        center: Point,
        /// Its radius; a negative one shows the inside only.
        radius: f64,
    },
    /// A flat polygon: its corners, anticlockwise as one faces it.
    Polygon(Vec<Point>),
    /// A flat polygon lit as a piece of a curved surface: corners with the normals there.
    Patch(Vec<(Point, Point)>),
}

impl Scene {
    /// Answers the largest magnitude of a coordinate: of the eye, of what it looks at, lights and shapes.
    pub fn largest(&self) -> f64 {
        let View { from, at, hither, .. } = &self.view;
        let lights = self.lights.iter().map(|light| reach(&light.position));
        let shapes = self.objects.iter().map(|object| object.shape.largest());
        let view = [reach(from), reach(at), *hither];
        view.into_iter().chain(lights).chain(shapes).fold(0.0, f64::max)
    }

    /// Answers the same scene with all lengths multiplied by a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        let point = |p: &Point| p.map(|c| c * factor);
        let View { from, at, hither, .. } = &self.view;
        let view = View { from: point(from), at: point(at), hither: hither * factor, ..self.view.clone() };
        let light = |light: &Light| Light { position: point(&light.position), ..light.clone() };
        let object = |object: &Object| Object { shape: object.shape.scaled(factor), ..object.clone() };
        Self {
            view,
            lights: self.lights.iter().map(light).collect(),
            objects: self.objects.iter().map(object).collect(),
            ..self.clone()
        }
    }
}

impl Shape {
    fn largest(&self) -> f64 {
        match self {
            Self::Cone { ends, radii } => {
                let end = |(end, radius): (&Point, &f64)| reach(end) + radius.abs();
                ends.iter().zip(radii).map(end).fold(0.0, f64::max)
            }
            Self::Sphere { center, radius } => reach(center) + radius.abs(),
            Self::Polygon(corners) => corners.iter().map(reach).fold(0.0, f64::max),
            Self::Patch(corners) => corners.iter().map(|(point, _)| reach(point)).fold(0.0, f64::max),
        }
    }

    fn scaled(&self, factor: f64) -> Self {
        let point = |p: &Point| p.map(|c| c * factor);
        match self {
            Self::Cone { ends, radii } => {
                Self::Cone { ends: ends.each_ref().map(point), radii: radii.map(|r| r * factor) }
            }
            Self::Sphere { center, radius } => {
                Self::Sphere { center: point(center), radius: radius * factor }
            }
            Self::Polygon(corners) => Self::Polygon(corners.iter().map(point).collect()),
            Self::Patch(corners) => {
                Self::Patch(corners.iter().map(|(corner, normal)| (point(corner), *normal)).collect())
            }
        }
    }
}

/// Answers the largest magnitude of a point's coordinates.
fn reach(point: &Point) -> f64 {
    point.iter().fold(0.0, |most, c| c.abs().max(most))
}
