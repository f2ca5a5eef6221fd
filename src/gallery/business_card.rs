//! A scene after P. Heckbert's and A. Kensler's ray tracers on business cards, with one ray a pixel
//! and hard shadows; the far tiles of the floor do not reflect as they do there.

super::in_every_number! {
    static OBJECTS: [Object<S>; 5] = [
        Object::new(Shape::Sphere(Sphere::new(v(5.0, 15.0, 8.0), n(5.0))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(-6.0, 12.0, 4.0), n(3.0))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(1.0, 10.0, 2.0), n(2.0))), 1),
        Object::new(Shape::Sphere(Sphere::new(v(0.0, 9.0, 5.0), n(1.0))), 2),
        Object::new(Shape::Plane(Plane::new(Vec3::ZERO, v(0.0, 0.0, 1.0))), 3),
    ];
    static MATERIALS: [Material<S>; 4] = [
        Material::matte(gray(0.1)).with_specular(Rgb::WHITE, 99).with_mirror(n(0.5)),
        Material::matte(rgb(0.0, 0.5, 0.0)).with_specular(Rgb::WHITE, 99).with_mirror(n(0.2)),
        Material::matte(rgb(0.0, 0.35, 0.5)).with_specular(Rgb::WHITE, 99).with_mirror(n(0.3)),
        Material::textured(Texture::Checker(Checker::new(gray(0.6), rgb(0.6, 0.2, 0.2), n(0.2)))),
    ];
    static LIGHTS: [Light<S>; 1] = [Light::point(v(9.0, 6.0, 16.0), Rgb::WHITE)];

    /// Four balls over a red and white floor under a purple sky.
    pub const VIEW: View<S> = View {
        name: "business-card",
        about: "balls over a red and white floor, after the ray tracers on business cards (Heckbert, Kensler); shadows are hard",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.5))
            .with_sky(Sky::Gradient {
                up: v(0.0, 0.0, 1.0),
                nadir: rgb(1.6, 0.4, 1.5),
                zenith: rgb(0.0, 0.0, 0.1),
            }),
        camera: Camera::perspective(v(0.0, 0.0, 3.0), v(1.0, 8.0, 4.0), v(0.0, 0.0, 1.0), n(46.5)),
        settings: Settings::new().with_depth(3).with_transfer(Transfer::Linear),
        size: [320, 240],
    };
}
