//! Balls between two mirrors that face each other: each level of reflection adds a room.

super::in_every_number! {
    static OBJECTS: [Object<S>; 6] = [
        Object::new(Shape::Cuboid(Cuboid::new(v(-4.0, 0.0, -5.0), v(4.0, 0.0, 3.0))), 0),
        Object::new(Shape::Cuboid(Cuboid::new(v(-3.0, 0.1, -4.3), v(3.4, 2.6, -4.1))), 1),
        Object::new(Shape::Cuboid(Cuboid::new(v(-3.0, 0.1, 1.4), v(3.4, 2.6, 1.6))), 1),
        Object::new(Shape::Sphere(Sphere::new(v(0.2, 0.8, -1.4), n(0.8))), 2),
        Object::new(Shape::Sphere(Sphere::new(v(-1.6, 0.5, -2.4), n(0.5))), 3),
        Object::new(Shape::Sphere(Sphere::new(v(1.7, 0.45, -2.6), n(0.45))), 4),
    ];
    static MATERIALS: [Material<S>; 5] = [
        Material::textured(Texture::Checker(Checker::new(gray(0.75), rgb(0.2, 0.25, 0.35), n(8.0)))),
        Material::matte(gray(0.05)).with_mirror(n(0.85)),
        Material::matte(gray(0.15)).with_specular(gray(0.6), 60).with_mirror(n(0.7)),
        Material::matte(rgb(0.85, 0.15, 0.1)).with_specular(gray(0.5), 40),
        Material::matte(rgb(0.1, 0.6, 0.2)).with_specular(gray(0.5), 40),
    ];
    static LIGHTS: [Light<S>; 1] = [Light::point(v(3.0, 6.0, 4.0), gray(0.9))];

    /// Two mirrors face to face and a silver ball.
    pub const VIEW: View<S> = View {
        name: "mirror-levels",
        about: "balls between mirrors: draw it at depth 1 to 5 to see one to five levels of reflection",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.12))
            .with_sky(Sky::Gradient {
                up: v(0.0, 1.0, 0.0),
                nadir: gray(0.9),
                zenith: rgb(0.15, 0.35, 0.75),
            }),
        camera: Camera::perspective(v(2.1, 1.9, 1.2), v(-0.2, 1.0, -2.4), v(0.0, 1.0, 0.0), n(58.0)),
        settings: Settings::new().with_depth(5),
        size: [320, 240],
    };
}
