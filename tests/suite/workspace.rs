//! A workspace that has drawn one scene draws another as if it were new.

use crate::kit::Kit;
use embedded_graphics::prelude::Size;
use scanray::math::Scalar;
use scanray::{
    Camera, Light, Material, Object, Plane, Renderer, Rgb, Scene, Settings, Shape, Sphere, Vec3, Workspace,
};

in_every_number! {
    what_casts_no_shadow_in_one_scene_casts_its_own_in_the_next,
}

mod checks {
    use super::*;

    const SIZE: u32 = 8;

    type Memory<S> = Workspace<S, [u8; 2], 0, 0>;

    /// Draws a floor under what else there is, all of it seen near one point.
    fn draw<S: Scalar>(kit: &Kit<S>, objects: &[Object<S>], workspace: &mut Memory<S>) -> Vec<Rgb<S>> {
        let materials = [Material::matte(Rgb::WHITE)];
        let lights = [Light::point(kit.v(0.0, 9.0, 0.0), Rgb::WHITE)];
        let scene = Scene::new(objects, &materials, &lights);
        let camera =
            Camera::perspective(kit.v(3.0, 2.0, 0.0), Vec3::ZERO, kit.v(0.0, 1.0, 0.0), (kit.0)(2.0));
        let (size, settings) = (Size::new(SIZE, SIZE), Settings::new().with_depth(0));
        let mut renderer = Renderer::new(&scene, &camera, size, settings, workspace).expect("a good scene");
        let mut picture = Vec::new();
        for y in 0..SIZE {
            renderer.trace_row(y, 0..SIZE, &mut (), |_, light| picture.push(light)).expect("a row");
        }
        picture
    }

    pub fn what_casts_no_shadow_in_one_scene_casts_its_own_in_the_next<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let floor = Object::new(Shape::Plane(Plane::new(Vec3::ZERO, kit.v(0.0, 1.0, 0.0))), 0);
        let ball = Object::new(Shape::Sphere(Sphere::new(kit.v(0.0, 6.0, 0.0), make(1.0))), 0);
        let mut workspace = Memory::new();
        let lit = draw(&kit, &[floor], &mut workspace);
        assert!(lit.iter().all(|light| read(light.g) > 0.9), "{lit:?}");
        let shadowed = draw(&kit, &[floor, ball], &mut workspace);
        assert!(shadowed.iter().all(|light| *light == Rgb::BLACK), "{shadowed:?}");
    }
}
