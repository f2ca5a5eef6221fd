//! "Uma cena simples": a ball over a floor before a wall, from the lecture on ray tracing of
//! M. Gattass (PUC-Rio). Sky, ambient light and highlight are ours: the lecture leaves them open.

super::in_every_number! {
    static OBJECTS: [Object<S>; 3] = [
        Object::new(Shape::Sphere(Sphere::new(v(0.0, 20.0, 0.0), n(25.0))), 0),
        Object::new(Shape::Cuboid(Cuboid::new(v(-80.0, -50.0, -50.0), v(50.0, -45.0, 50.0))), 1),
        Object::new(Shape::Cuboid(Cuboid::new(v(-80.0, -50.0, -60.0), v(50.0, 50.0, -50.0))), 1),
    ];
    static MATERIALS: [Material<S>; 2] = [
        Material::matte(rgb(0.0, 0.0, 1.0)).with_specular(gray(0.6), 30),
        Material::matte(rgb(0.7, 0.7, 0.0)),
    ];
    static LIGHTS: [Light<S>; 1] = [Light::point(v(60.0, 120.0, 40.0), gray(0.8))];

    /// The lecture's scene with light, shadow and highlight.
    pub const VIEW: View<S> = View {
        name: "simple",
        about: "a ball, a floor and a wall: the scene of the lectures this tracer follows (Gattass, PUC-Rio)",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.2))
            .with_sky(Sky::Solid(rgb(0.05, 0.07, 0.1))),
        camera: Camera::perspective(v(100.0, 40.0, 40.0), Vec3::ZERO, v(0.0, 1.0, 0.0), n(90.0))
            .with_clip(n(30.0), n(230.0)),
        settings: Settings::new(),
        size: [240, 240],
    };
}
