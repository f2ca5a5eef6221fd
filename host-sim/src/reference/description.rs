//! What the reference draws: plain data of its own, which the door copies out of the core's types.

use super::cone::Cone;
use super::displaced::Displaced;
use super::field::Field;
use super::glass::Glass;
use super::raster::{Image, Raster};
use super::smooth::Smooth;
use super::vector::Vector;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// Tells that a description holds something the reference has no formula for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unknown(
    /// What kind of thing it is.
    pub &'static str,
);

impl fmt::Display for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the reference does not know this kind of {}", self.0)
    }
}

impl std::error::Error for Unknown {}

/// Holds all that a picture is made of.
#[derive(Clone, Debug)]
pub struct Description {
    pub(super) objects: Vec<Object>,
    pub(super) groups: Vec<Group>,
    pub(super) lights: Vec<Light>,
    pub(super) sky: Sky,
    pub(super) ambient: Vector,
    pub(super) volume: Option<Volume>,
    pub(super) camera: Camera,
    pub(super) depth: u8,
    pub(super) exposure: f64,
}

/// Is objects that stand side by side in the list: one, or neighbours in a mesh with a ball around them, which a
/// ray that misses it need not be asked about.
#[derive(Clone, Debug)]
pub(super) struct Group {
    pub members: Range<usize>,
    pub ball: Option<(Vector, f64)>,
}

/// Is a body that light comes through.
#[derive(Clone, Debug)]
pub(super) struct Volume {
    pub field: Field,
    /// Value, colour and opacity of each class.
    pub classes: Vec<(f64, Vector, f64)>,
    pub density: f64,
    /// Whether the value is that of the nearest node.
    pub nearest: bool,
    /// Number of samples of each piece.
    pub samples: u32,
    /// The transparency at which a ray ends.
    pub faintest: f64,
}

#[derive(Clone, Debug)]
pub(super) struct Object {
    /// Place in the scene's list: the triangles of a mesh are objects of one place.
    pub number: usize,
    pub shape: Shape,
    pub material: Material,
}

#[derive(Clone, Debug)]
pub(super) enum Shape {
    Displaced(Displaced),
    Level { field: Field, level: f64 },
    Sphere { center: Vector, radius: f64 },
    Plane { point: Vector, normal: Vector },
    Triangle { corners: [Vector; 3] },
    Cuboid { low: Vector, high: Vector },
    Polygon { vertices: Vec<Vector>, normal: Vector, odd_even: bool },
    Cone(Cone),
    Smooth(Smooth),
}

#[derive(Clone, Debug)]
pub(super) struct Material {
    pub texture: Texture,
    pub bump: Option<Bump>,
    pub model: Model,
    pub ambient: f64,
    pub specular: Vector,
    pub shininess: u16,
    pub mirror: f64,
    pub glass: Option<Glass>,
}

#[derive(Clone, Debug)]
pub(super) enum Bump {
    Heights { image: Image, height: f64 },
    Normals { image: Image },
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Model {
    Flat,
    Phong,
    BlinnPhong,
    CookTorrance { roughness: f64, index: f64 },
}

#[derive(Clone, Debug)]
pub(super) enum Texture {
    Solid(Vector),
    Checker { even: Vector, odd: Vector, per_unit: f64 },
    Vertices([Vector; 3]),
    Stripes { even: Vector, odd: Vector, per_unit: [f64; 2] },
    Rings { even: Vector, odd: Vector, center: [f64; 2], per_unit: f64 },
    Image(Image),
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Light {
    Point { position: Vector, color: Vector },
    Directional { toward: Vector, color: Vector },
    Spot { position: Vector, axis: Vector, cutoff: f64, falloff: u16, color: Vector },
}

#[derive(Clone, Debug)]
pub(super) enum Sky {
    Solid(Vector),
    Gradient { up: Vector, nadir: Vector, zenith: Vector },
    Cube { faces: [Arc<Raster>; 6], smooth: bool },
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    pub eye: Vector,
    pub center: Vector,
    pub up: Vector,
    pub projection: Projection,
    pub near: f64,
    pub far: f64,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Projection {
    Perspective { fovy: f64 },
    Frustum { edges: [f64; 4] },
    Orthographic { height: f64 },
}

/// Is how light becomes what a panel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Output {
    /// Highest levels of red, green and blue.
    pub(super) tops: [f64; 3],
    pub(super) colored: bool,
    /// Whether levels follow the sRGB curve, else they follow the light.
    pub(super) srgb: bool,
    pub(super) rounding: Rounding,
}

/// Names how levels are rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Rounding {
    Nearest,
    /// By Bayer's matrix of side 8.
    Ordered,
    /// By these thresholds, of 2^16.
    Mask(&'static [[u16; 16]; 16]),
    /// Handing the error to the right.
    Diffused,
}
