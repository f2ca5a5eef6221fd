//! A ray tracer for microcontroller displays.
//!
#![cfg_attr(
    doc,
    doc = concat!(
        "![three balls on a chessboard](data:image/png;base64,",
        include_str!("../pictures/three-spheres.base64"),
        ")"
    )
)]
//!
//! No allocator, no `unsafe`, no recursion: scanray traces a row of rays into a scanline, encodes
//! the row for the panel and hands it to any [`embedded-graphics`] `DrawTarget` with one
//! `fill_contiguous`. The RAM it takes is one [`Workspace`]; scenes live in flash.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
//! use scanray::*;
//!
//! static OBJECTS: [Object; 2] = [
//!     Object::new(Shape::Sphere(Sphere::new(Vec3::new(0.0, 1.0, 0.0), 1.0)), 0),
//!     Object::new(Shape::Plane(Plane::new(Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0))), 1),
//! ];
//! static MATERIALS: [Material; 2] =
//!     [Material::matte(Rgb::new(0.9, 0.2, 0.1)).with_mirror(0.2), Material::matte(Rgb::gray(0.6))];
//! static LIGHTS: [Light; 1] = [Light::point(Vec3::new(3.0, 5.0, 4.0), Rgb::WHITE)];
//!
//! let scene = Scene::new(&OBJECTS, &MATERIALS, &LIGHTS).with_ambient(Rgb::gray(0.1));
//! let camera = Camera::perspective(
//!     Vec3::new(0.0, 1.5, 5.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 1.0, 0.0), 40.0);
//! let mut workspace = Workspace::<f32, Rgb565, 64, 2>::new();
//! let mut display = MockDisplay::<Rgb565>::new();
//! let size = display.bounding_box().size;
//! let Ok(()) = Renderer::new(&scene, &camera, size, Settings::new(), &mut workspace)?.draw(&mut display);
//! # Ok::<(), RenderError>(())
//! ```
//!
//! # The pipeline, and where each part lives
//!
//! ```text
//! scene (flash) -> camera: axes and window, once a picture
//!   -> row: rays by forward differences; spans: which objects can be met, between which columns
//!     -> eight rays, of one pixel each or several: visibility -> surface -> shade
//!         -> mirrors, level by level; glass, ray by ray -> the mean of a pixel's rays: linear light
//!       -> exposure, transfer curve, dithering -> the panel's colour -> scanline
//!         -> fill_contiguous, or a buffer of the caller's
//! ```
//!
//! - [`math`]: the [`Scalar`] trait and its numbers `f32`, [`Fixed`], `f64`; vectors.
//! - [`ray`], [`hit`], [`aabb`], [`hull`], [`color`], [`fault`]: what everything else speaks of.
//! - [`spectrum`]: colours from spectra, at compile time.
//! - [`accel`]: hierarchies over many things.
//! - [`shape`]: one file a shape, and room for your own ([`Intersect`]).
//! - [`texture`], [`material`], [`brdf`], [`glass`], [`light`], [`environment`]: what surfaces do with light.
//! - [`volume`]: fields on a grid of voxels: bodies that light comes through, and walks through them.
//! - [`scene`]: [`Scene`] borrows it all, [`SceneBuffer`] owns it, [`Scene::check`] judges it.
//! - [`camera`]: which ray belongs to which pixel.
//! - [`trace`]: what a ray meets, how it is lit, where the light goes on.
//! - [`output`]: from linear light to the panel's bits.
//! - [`render`]: [`Renderer`] and [`Workspace`]; how many rays a picture takes ([`Quality`]), and pictures that
//!   become finer ([`Progress`]).
//! - [`raster`]: the other approach, a z-buffer: [`RasterRenderer`] and [`RasterWorkspace`].
//! - [`gallery`]: scenes ready to draw, in every number.
//!
//! The numbers are types, not features: no flag changes a picture. Features say what a program carries beside
//! spheres, planes, triangles, boxes, Phong's light and mirrors: `shapes`, `images`, `glass`, `models` and
//! `volumes`, all by default. A scene that needs what was left out is refused by the name of the feature ([`Fault::LeftOut`]).
//!
//! [`embedded-graphics`]: https://docs.rs/embedded-graphics
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod math;

pub mod aabb;
pub mod color;
pub mod fault;
pub mod hit;
pub mod hull;
pub mod ray;
pub mod spectrum;

pub mod accel;

pub mod shape;

pub mod brdf;
pub mod environment;
pub mod glass;
pub mod light;
pub mod material;
pub mod texture;
pub mod volume;

pub mod scene;

pub mod camera;

pub mod trace;

pub mod output;

pub mod render;

pub mod raster;

pub mod gallery;

pub use brdf::CookTorrance;
pub use camera::{Camera, CameraError, Projection};
pub use color::Rgb;
pub use environment::{Cube, Sky};
pub use fault::Fault;
pub use glass::{Fresnel, Glass};
pub use light::{Light, Spot};
pub use material::{Material, Model};
pub use math::{Fixed, Scalar, Vec3};
pub use output::{Dither, Encode, Transfer};
pub use raster::{RasterRenderer, RasterWorkspace};
pub use render::{Adaptive, AtEdges, Exact, Jittered, Pointwise, Quality, Uniform};
pub use render::{Progress, RenderError, Renderer, RowError, Settings, Workspace};
pub use scene::{Full, Object, Scene, SceneBuffer, SceneError};
pub use shape::{
    Cone, Corners, Cuboid, Displaced, FillRule, Intersect, Isosurface, Mesh, Normals, Plane, Polygon, Shape,
    SmoothTriangle, Sphere, Triangle, Vertex,
};
pub use texture::{
    Bitmap, Bump, Checker, Filter, Image, Procedural, Relief, Rings, Stripes, Texels, Texture, Vertices,
};
pub use volume::{Class, Gradient, Grid, Reconstruction, Volume, Voxels};

/// Runs the README's example as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
