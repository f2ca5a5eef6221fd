//! The scene, in `f32`: this chip has a floating-point unit.
//!
//! Lengths are in units of your own, up to 1024; y is up. Colours are linear light from 0 to 1. To make this file of a
//! scene file, a model or a scene of the gallery: `scanray bake FILE --number f32 -o src/scene.rs`.

use scanray::{
    Camera, Checker, Light, Material, Object, Plane, Rgb, Scene, Settings, Shape, Sky, Sphere, Texture, Vec3,
};

/// Lists what there is to see: a shape each, and the number of its material.
static OBJECTS: [Object; 6] = [
    Object::new(Shape::Plane(Plane::new(Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0))), 0),
    ball(Vec3::new(0.0, 1.0, -0.7), 1.0, 1),
    ball(Vec3::new(-1.5, 0.65, 0.3), 0.65, 2),
    ball(Vec3::new(1.35, 0.5, 0.6), 0.5, 3),
    ball(Vec3::new(-0.45, 0.27, 1.35), 0.27, 4),
    ball(Vec3::new(0.45, 0.2, 1.75), 0.2, 5),
];

static MATERIALS: [Material; 6] = [
    Material::textured(Texture::Checker(Checker::new(
        Rgb::new(0.85, 0.8, 0.7),
        Rgb::new(0.1, 0.16, 0.2),
        1.0,
    ))),
    Material::matte(Rgb::gray(0.12)).with_specular(Rgb::gray(0.8), 80).with_mirror(0.8),
    glossy(Rgb::new(0.85, 0.13, 0.06)),
    glossy(Rgb::new(0.05, 0.25, 0.75)),
    glossy(Rgb::new(0.9, 0.55, 0.05)),
    glossy(Rgb::new(0.1, 0.5, 0.2)),
];

static LIGHTS: [Light; 2] = [
    Light::point(Vec3::new(-4.0, 6.0, 4.5), Rgb::new(0.95, 0.88, 0.75)),
    Light::point(Vec3::new(5.0, 4.0, 3.0), Rgb::new(0.12, 0.16, 0.24)),
];

/// Is all there is, and the light that comes from everywhere.
pub static SCENE: Scene<'static> =
    Scene::new(&OBJECTS, &MATERIALS, &LIGHTS).with_ambient(Rgb::gray(0.1)).with_sky(Sky::Gradient {
        up: Vec3::new(0.0, 1.0, 0.0),
        nadir: Rgb::new(0.9, 0.85, 0.8),
        zenith: Rgb::new(0.05, 0.22, 0.7),
    });

/// Stands at the first point, looks at the second, and sees 44 degrees from the lower edge to the upper.
pub const CAMERA: Camera =
    Camera::perspective(Vec3::new(0.6, 1.7, 5.2), Vec3::new(0.0, 0.65, 0.0), Vec3::new(0.0, 1.0, 0.0), 44.0);

/// Lets light meet two mirrors on its way.
pub const SETTINGS: Settings = Settings::new().with_depth(2);

const fn ball(center: Vec3, radius: f32, material: u16) -> Object {
    Object::new(Shape::Sphere(Sphere::new(center, radius)), material)
}

const fn glossy(color: Rgb) -> Material {
    Material::matte(color).with_specular(Rgb::gray(0.5), 60).with_mirror(0.08)
}
