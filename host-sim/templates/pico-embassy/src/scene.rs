//! The scene, in fixed point: this chip has no floating-point unit.
//!
//! Lengths are in units of your own, up to 1024; y is up. Colours are linear light from 0 to 1. To make this file of a
//! scene file, a model or a scene of the gallery: `scanray bake FILE --number fixed -o src/scene.rs`.

use scanray::{
    Camera, Checker, Fixed, Light, Material, Object, Plane, Rgb, Scene, Settings, Shape, Sky, Sphere,
    Texture, Vec3,
};

/// Lists what there is to see: a shape each, and the number of its material.
static OBJECTS: [Object<Fixed>; 6] = [
    Object::new(Shape::Plane(Plane::new(Vec3::ZERO, v(0.0, 1.0, 0.0))), 0),
    ball(v(0.0, 1.0, -0.7), 1.0, 1),
    ball(v(-1.5, 0.65, 0.3), 0.65, 2),
    ball(v(1.35, 0.5, 0.6), 0.5, 3),
    ball(v(-0.45, 0.27, 1.35), 0.27, 4),
    ball(v(0.45, 0.2, 1.75), 0.2, 5),
];

static MATERIALS: [Material<Fixed>; 6] = [
    Material::textured(Texture::Checker(Checker::new(rgb(0.85, 0.8, 0.7), rgb(0.1, 0.16, 0.2), n(1.0)))),
    Material::matte(gray(0.12)).with_specular(gray(0.8), 80).with_mirror(n(0.8)),
    glossy(rgb(0.85, 0.13, 0.06)),
    glossy(rgb(0.05, 0.25, 0.75)),
    glossy(rgb(0.9, 0.55, 0.05)),
    glossy(rgb(0.1, 0.5, 0.2)),
];

static LIGHTS: [Light<Fixed>; 2] = [
    Light::point(v(-4.0, 6.0, 4.5), rgb(0.95, 0.88, 0.75)),
    Light::point(v(5.0, 4.0, 3.0), rgb(0.12, 0.16, 0.24)),
];

/// Is all there is, and the light that comes from everywhere.
pub static SCENE: Scene<'static, Fixed> =
    Scene::new(&OBJECTS, &MATERIALS, &LIGHTS).with_ambient(gray(0.1)).with_sky(Sky::Gradient {
        up: v(0.0, 1.0, 0.0),
        nadir: rgb(0.9, 0.85, 0.8),
        zenith: rgb(0.05, 0.22, 0.7),
    });

/// Stands at the first point, looks at the second, and sees 44 degrees from the lower edge to the upper.
pub const CAMERA: Camera<Fixed> =
    Camera::perspective(v(0.6, 1.7, 5.2), v(0.0, 0.65, 0.0), v(0.0, 1.0, 0.0), n(44.0));

/// Lets light meet two mirrors on its way.
pub const SETTINGS: Settings<Fixed> = Settings::new().with_depth(2);

const fn ball(center: Vec3<Fixed>, radius: f64, material: u16) -> Object<Fixed> {
    Object::new(Shape::Sphere(Sphere::new(center, n(radius))), material)
}

const fn glossy(color: Rgb<Fixed>) -> Material<Fixed> {
    Material::matte(color).with_specular(gray(0.5), 60).with_mirror(n(0.08))
}

const fn n(value: f64) -> Fixed {
    Fixed::new(value)
}

const fn v(x: f64, y: f64, z: f64) -> Vec3<Fixed> {
    Vec3::from_f64(x, y, z)
}

const fn rgb(r: f64, g: f64, b: f64) -> Rgb<Fixed> {
    Rgb::from_f64(r, g, b)
}

const fn gray(level: f64) -> Rgb<Fixed> {
    Rgb::gray(n(level))
}
