//! Three balls on a chessboard: the card on which speed is measured.

super::in_every_number! {
    static OBJECTS: [Object<S>; 4] = [
        Object::new(Shape::Plane(Plane::new(Vec3::ZERO, v(0.0, 1.0, 0.0))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(-1.6, 0.8, -0.4), n(0.8))), 1),
        Object::new(Shape::Sphere(Sphere::new(v(0.0, 1.0, -1.0), n(1.0))), 2),
        Object::new(Shape::Sphere(Sphere::new(v(1.5, 0.6, 0.4), n(0.6))), 3),
    ];
    static MATERIALS: [Material<S>; 4] = [
        Material::textured(Texture::Checker(Checker::new(gray(0.9), gray(0.25), n(1.0)))),
        Material::matte(rgb(0.9, 0.2, 0.15)).with_specular(gray(0.4), 32),
        Material::matte(gray(0.5)).with_specular(gray(0.4), 32).with_mirror(n(0.6)),
        Material::matte(rgb(0.2, 0.35, 0.9)).with_specular(gray(0.4), 32),
    ];
    static LIGHTS: [Light<S>; 1] = [Light::point(v(4.0, 6.0, 4.0), Rgb::WHITE)];

    /// Three balls on a chessboard.
    pub const VIEW: View<S> = View {
        name: "three-spheres",
        about: "three balls, one a mirror, on an endless chessboard: the card on which speed is measured",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.12))
            .with_sky(Sky::Gradient {
                up: v(0.0, 1.0, 0.0),
                nadir: Rgb::WHITE,
                zenith: rgb(0.5, 0.7, 1.0),
            }),
        camera: Camera::perspective(v(0.0, 1.2, 4.5), v(0.0, 0.6, 0.0), v(0.0, 1.0, 0.0), n(50.0)),
        settings: Settings::new(),
        size: [320, 240],
    };
}
