//! A display that watches how it is drawn on, and small scenes.

pub mod picture;

mod panel;

pub use panel::{BusFault, Memory, Panel, is_a_row, memory, panel, panel_of, pixels, written};

use embedded_graphics::prelude::Size;
use scanray::render::Quality;
use scanray::trace::Observer;
use scanray::{
    Camera, Intersect, Light, Material, Object, Plane, Renderer, Rgb, Scalar, Scene, Settings, Shape, Sphere,
    Vec3, Workspace,
};

/// Traces the light of a picture.
pub fn film<S: Scalar, X: Intersect<S>, Q: Quality>(
    scene: &Scene<'_, S, X>,
    camera: &Camera<S>,
    size: [u32; 2],
    settings: Settings<S, Q>,
    observer: &mut impl Observer,
) -> Vec<Rgb<S>> {
    film_rows(scene, camera, size, 0..size[1], settings, observer)
}

/// Traces the light of some rows of a picture.
pub fn film_rows<S: Scalar, X: Intersect<S>, Q: Quality>(
    scene: &Scene<'_, S, X>,
    camera: &Camera<S>,
    [columns, rows]: [u32; 2],
    which: impl Iterator<Item = u32>,
    settings: Settings<S, Q>,
    observer: &mut impl Observer,
) -> Vec<Rgb<S>> {
    let mut workspace = Workspace::<S, [u8; 2], 0, 5>::new();
    let size = Size::new(columns, rows);
    let mut renderer =
        Renderer::new(scene, camera, size, settings, &mut workspace).expect("a picture that can be drawn");
    let mut film = Vec::new();
    for y in which {
        renderer.trace_row(y, 0..columns, observer, |_, light| film.push(light)).expect("a row of it");
    }
    film
}

pub const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

pub const fn ball(x: f32, y: f32, z: f32, radius: f32, material: u16) -> Object {
    Object::new(Shape::Sphere(Sphere::new(v(x, y, z), radius)), material)
}

pub static OBJECTS: [Object; 4] = [
    Object::new(Shape::Plane(Plane::new(v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0))), 0),
    ball(0.0, 1.0, 0.0, 1.0, 1),
    ball(-1.5, 0.5, 1.0, 0.5, 2),
    ball(1.4, 0.4, 1.1, 0.4, 2),
];
pub static MATERIALS: [Material; 3] = [
    Material::matte(Rgb::gray(0.6)),
    Material::matte(Rgb::new(0.3, 0.3, 0.4)).with_mirror(0.5).with_specular(Rgb::gray(0.5), 40),
    Material::matte(Rgb::new(0.9, 0.2, 0.1)).with_mirror(0.2),
];
pub static LIGHTS: [Light; 2] = [
    Light::point(v(3.0, 5.0, 4.0), Rgb::gray(0.7)),
    Light::directional(v(-1.0, 2.0, 1.0), Rgb::new(0.1, 0.2, 0.3)),
];

pub const fn scene() -> Scene<'static> {
    Scene::new(&OBJECTS, &MATERIALS, &LIGHTS).with_ambient(Rgb::gray(0.1))
}

pub const fn camera() -> Camera {
    Camera::perspective(v(0.0, 2.0, 6.0), v(0.0, 0.8, 0.0), v(0.0, 1.0, 0.0), 45.0)
}
