//! Glass: a ball with a bubble of air in it, a block of green glass that darkens with the way
//! through it, and a ball that bends the light and nothing else.

super::in_every_number! {
    static OBJECTS: [Object<S>; 7] = [
        Object::new(Shape::Cuboid(Cuboid::new(v(-7.0, 0.0, -9.0), v(7.0, 0.0, 5.0))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(-0.9, 1.0, 0.2), n(1.0))), 1),
        Object::new(Shape::Sphere(Sphere::new(v(-0.75, 1.15, 0.35), n(0.5))), 2),
        Object::new(Shape::Cuboid(Cuboid::new(v(0.55, 0.05, -1.2), v(1.75, 1.35, 0.2))), 3),
        Object::new(Shape::Sphere(Sphere::new(v(0.75, 0.45, 1.35), n(0.45))), 4),
        Object::new(Shape::Sphere(Sphere::new(v(-2.6, 0.8, -2.4), n(0.8))), 5),
        Object::new(Shape::Sphere(Sphere::new(v(2.9, 0.6, -2.0), n(0.6))), 6),
    ];
    static MATERIALS: [Material<S>; 7] = [
        Material::textured(Texture::Checker(Checker::new(rgb(0.85, 0.8, 0.7), rgb(0.25, 0.3, 0.4), n(14.0)))),
        // What glass reflects of lamps is its highlight; it has no colour of its own.
        Material::matte(Rgb::BLACK).with_specular(gray(0.7), 200)
            .with_glass(Glass::new(n(1.0), n(1.5)).with_fresnel(Fresnel::Exact)),
        Material::matte(Rgb::BLACK).with_glass(Glass::new(n(1.0), n(1.0)).with_fresnel(Fresnel::Exact)),
        Material::matte(Rgb::BLACK).with_specular(gray(0.5), 100).with_glass(
            Glass::new(n(1.0), n(1.5)).with_fresnel(Fresnel::Schlick).with_absorption(rgb(0.9, 0.12, 0.6)),
        ),
        Material::matte(Rgb::BLACK).with_specular(gray(0.7), 200)
            .with_glass(Glass::new(n(0.95), n(1.5))),
        Material::matte(rgb(0.85, 0.2, 0.1)).with_specular(gray(0.4), 40),
        Material::matte(rgb(0.9, 0.65, 0.1)).with_specular(gray(0.4), 40),
    ];
    static LIGHTS: [Light<S>; 1] = [Light::point(v(4.0, 7.0, 5.0), gray(0.9))];

    /// Two balls and a block of glass.
    pub const VIEW: View<S> = View {
        name: "glass",
        about: "a glass ball with a bubble, a block that colours what passes it, a clear ball: refraction, total reflection, Fresnel, Beer",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.25))
            .with_sky(Sky::Gradient {
                up: v(0.0, 1.0, 0.0),
                nadir: gray(0.95),
                zenith: rgb(0.25, 0.45, 0.85),
            }),
        camera: Camera::perspective(v(0.6, 1.9, 5.2), v(0.15, 0.75, 0.0), v(0.0, 1.0, 0.0), n(40.0)),
        settings: Settings::new().with_depth(5),
        size: [320, 240],
    };
}
