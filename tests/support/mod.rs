//! Displays that watch how they are drawn on, and small scenes.
#![allow(dead_code, reason = "each test uses its part")]

pub mod picture;

use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
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
    [columns, rows]: [u32; 2],
    settings: Settings<S, Q>,
    observer: &mut impl Observer,
) -> Vec<Rgb<S>> {
    let mut workspace = Workspace::<S, [u8; 2], 0, 5>::new();
    let size = Size::new(columns, rows);
    let mut renderer =
        Renderer::new(scene, camera, size, settings, &mut workspace).expect("a picture that can be drawn");
    let mut film = Vec::new();
    for y in 0..rows {
        renderer.trace_row(y, 0..columns, observer, |_, light| film.push(light)).expect("a row of it");
    }
    film
}

/// Is a display that accepts nothing but whole rows from `fill_contiguous`, and can fail.
pub struct StrictDisplay<C> {
    pub area: Rectangle,
    pub pixels: Vec<Option<C>>,
    pub fills: Vec<Rectangle>,
    /// How many fills succeed before one fails.
    pub fails_after: Option<usize>,
}

#[derive(Debug, PartialEq, Eq)]
pub struct BusFault(pub usize);

impl<C: PixelColor> StrictDisplay<C> {
    pub fn new(area: Rectangle) -> Self {
        let count = (area.size.width * area.size.height) as usize;
        Self { area, pixels: vec![None; count], fills: Vec::new(), fails_after: None }
    }

    pub fn sized(width: u32, height: u32) -> Self {
        Self::new(Rectangle::new(Point::zero(), Size::new(width, height)))
    }

    pub fn is_full(&self) -> bool {
        self.pixels.iter().all(Option::is_some)
    }
}

impl<C> Dimensions for StrictDisplay<C> {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl<C: PixelColor> DrawTarget for StrictDisplay<C> {
    type Color = C;
    type Error = BusFault;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, _: I) -> Result<(), BusFault> {
        panic!("pixels were drawn one by one");
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(
        &mut self,
        row: &Rectangle,
        colors: I,
    ) -> Result<(), BusFault> {
        if self.fails_after == Some(self.fills.len()) {
            return Err(BusFault(self.fills.len()));
        }
        assert_eq!(row.size.height, 1, "not a row");
        assert_eq!(row.intersection(&self.area), *row, "outside the display");
        self.fills.push(*row);
        let colors: Vec<C> = colors.into_iter().collect();
        assert_eq!(colors.len(), row.size.width as usize, "as many colours as the row has pixels");
        let start = row.top_left - self.area.top_left;
        let first = start.y as usize * self.area.size.width as usize + start.x as usize;
        for (place, color) in self.pixels[first..].iter_mut().zip(colors) {
            *place = Some(color);
        }
        Ok(())
    }
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
