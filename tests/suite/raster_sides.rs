//! The z-buffer lights the side of a surface that is seen.

use crate::kit::Kit;
use embedded_graphics::prelude::Size;
use scanray::math::Scalar;
use scanray::{
    Camera, Light, Material, Object, RasterRenderer, RasterWorkspace, Rgb, Scene, Settings, Shape, Triangle,
    Vec3,
};

in_every_number! {
    a_triangle_is_lit_alike_on_both_sides,
}

mod checks {
    use super::*;

    const SIZE: u32 = 8;

    /// Answers the light of a triangle that fills the picture, lit from above the eye.
    fn light<S: Scalar>(kit: &Kit<S>, corners: [Vec3<S>; 3]) -> Vec<Rgb<S>> {
        let [a, b, c] = corners;
        let objects = [Object::new(Shape::Triangle(Triangle::new(a, b, c)), 0)];
        let materials = [Material::matte(Rgb::WHITE)];
        let lights = [Light::point(kit.v(0.0, 2.0, 4.0), Rgb::WHITE)];
        let scene: Scene<'_, S> = Scene::new(&objects, &materials, &lights);
        let eye = kit.v(0.0, 0.0, 4.0);
        let camera = Camera::perspective(eye, Vec3::ZERO, kit.v(0.0, 1.0, 0.0), (kit.0)(40.0));
        let mut workspace = RasterWorkspace::<S, { SIZE as usize }>::new();
        let size = Size::new(SIZE, SIZE);
        let mut renderer =
            RasterRenderer::new(&scene, &camera, size, Settings::new(), &mut workspace).expect("a scene");
        let mut picture = Vec::new();
        for y in 0..SIZE {
            renderer.shade_row(y, &mut (), |_, light| picture.push(light)).expect("a row of the picture");
        }
        picture
    }

    pub fn a_triangle_is_lit_alike_on_both_sides<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let [a, b, c] = [kit.v(-9.0, -5.0, 0.0), kit.v(9.0, -5.0, 0.0), kit.v(0.0, 9.0, 0.0)];
        let (front, back) = (light(&kit, [a, b, c]), light(&kit, [a, c, b]));
        assert_eq!(front.len(), back.len());
        for (pixel, (front, back)) in front.iter().zip(&back).enumerate() {
            let [front, back] = [front, back].map(|light| read(light.g));
            // The light falls in by 40 degrees at most.
            assert!(front > 0.75, "pixel {pixel}: {front}");
            assert!((front - back).abs() < 1e-4, "pixel {pixel}: {front} and {back}");
        }
    }
}
