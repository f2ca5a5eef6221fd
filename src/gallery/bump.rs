//! Three smooth balls whose bumps only light sees: the peel of an orange from a map of heights, a golf
//! ball from a map of normals, hammered metal that mirrors the others.

super::in_every_number! {
    use crate::gallery::images::{DIMPLES, PEEL};

    static OBJECTS: [Object<S>; 4] = [
        Object::new(Shape::Plane(Plane::new(Vec3::ZERO, v(0.0, 1.0, 0.0))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(-1.15, 0.85, 0.3), n(0.85))), 1),
        Object::new(Shape::Sphere(Sphere::new(v(0.85, 0.6, 1.1), n(0.6))), 2),
        Object::new(Shape::Sphere(Sphere::new(v(0.95, 1.05, -1.1), n(1.05))), 3),
    ];
    static MATERIALS: [Material<S>; 4] = [
        Material::matte(rgb(0.20, 0.22, 0.27)).with_mirror(n(0.15)),
        Material::matte(rgb(0.95, 0.38, 0.03))
            .with_specular(gray(0.35), 30)
            .with_bump(Bump::heights(Image::new(PEEL).with_tiles(n(6.0), n(3.0)), n(0.035))),
        Material::matte(gray(0.85))
            .with_specular(gray(0.3), 60)
            .with_bump(Bump::normals(Image::new(DIMPLES).with_tiles(n(16.0), n(8.0)))),
        Material::matte(rgb(0.10, 0.08, 0.06))
            .with_specular(rgb(0.9, 0.8, 0.6), 60)
            .with_mirror(n(0.65))
            .with_bump(Bump::heights(Image::new(PEEL).with_tiles(n(4.0), n(2.0)), n(0.04))),
    ];
    static LIGHTS: [Light<S>; 2] = [
        Light::point(v(-4.0, 5.5, 4.0), rgb(0.95, 0.90, 0.80)),
        Light::point(v(5.0, 2.5, 2.0), rgb(0.15, 0.20, 0.32)),
    ];

    /// Balls of orange peel, golf ball and hammered metal.
    pub const VIEW: View<S> = View {
        name: "bump",
        about: "an orange, a golf ball and hammered metal: smooth balls whose normals are turned",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.12))
            .with_sky(Sky::Gradient {
                up: v(0.0, 1.0, 0.0),
                nadir: rgb(0.90, 0.70, 0.50),
                zenith: rgb(0.03, 0.07, 0.22),
            }),
        camera: Camera::perspective(v(0.0, 1.9, 6.2), v(0.0, 0.95, 0.0), v(0.0, 1.0, 0.0), n(38.0)),
        settings: Settings::new().with_depth(2),
        size: [320, 240],
    };
}
