//! Small pictures in linear light, and how far they lie apart.

use super::v;
use embedded_graphics::prelude::Size;
use scanray::{
    Camera, Light, Material, Object, Renderer, Rgb, Scene, Settings, Shape, Sky, Sphere, Workspace,
};

pub const NIGHT: Sky = Sky::Solid(Rgb::BLACK);

pub fn ball(radius: f32) -> Shape {
    Shape::Sphere(Sphere::new(v(0.0, 0.0, 0.0), radius))
}

/// Draws a small picture, as seen from (0, 0.5, 6).
pub fn draw(objects: &[Object], materials: &[Material], sky: Sky) -> Vec<Rgb> {
    let lights = [Light::point(v(3.0, 4.0, 5.0), Rgb::WHITE)];
    let scene = Scene::new(objects, materials, &lights).with_ambient(Rgb::gray(0.1)).with_sky(sky);
    let camera = Camera::perspective(v(0.0, 0.5, 6.0), v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0), 40.0);
    let mut workspace = Workspace::<f32, [u8; 2], 0, 2>::new();
    let settings = Settings::new().with_depth(2);
    let mut renderer = Renderer::new(&scene, &camera, Size::new(60, 45), settings, &mut workspace).unwrap();
    let mut light = Vec::new();
    for y in 0..45 {
        renderer.trace_row(y, 0..60, &mut (), |_, color| light.push(color)).unwrap();
    }
    light
}

/// Counts the pixels of two pictures that differ by more than some light.
pub fn differing(a: &[Rgb], b: &[Rgb], by: f32) -> usize {
    let apart = |a: &Rgb, b: &Rgb| (a.r - b.r).abs().max((a.g - b.g).abs()).max((a.b - b.b).abs());
    a.iter().zip(b).filter(|(a, b)| apart(a, b) > by).count()
}
