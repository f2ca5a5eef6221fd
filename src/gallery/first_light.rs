//! The first picture of the lecture: what one gets by giving each pixel its object's colour.

super::in_every_number! {
    static OBJECTS: [Object<S>; 3] = [
        Object::new(Shape::Sphere(Sphere::new(v(0.0, 20.0, 0.0), n(25.0))), 0),
        Object::new(Shape::Cuboid(Cuboid::new(v(-80.0, -50.0, -50.0), v(50.0, -45.0, 50.0))), 1),
        Object::new(Shape::Cuboid(Cuboid::new(v(-80.0, -50.0, -60.0), v(50.0, 50.0, -50.0))), 1),
    ];
    static MATERIALS: [Material<S>; 2] =
        [Material::flat(rgb(0.0, 0.0, 1.0)), Material::flat(rgb(0.7, 0.7, 0.0))];

    /// The scene of `simple` without any light.
    pub const VIEW: View<S> = View {
        name: "first-light",
        about: "the scene `simple` without shading: every pixel has its object's colour",
        scene: Scene::new(&OBJECTS, &MATERIALS, &[]).with_sky(Sky::Solid(rgb(0.05, 0.07, 0.1))),
        camera: Camera::perspective(v(100.0, 40.0, 40.0), Vec3::ZERO, v(0.0, 1.0, 0.0), n(90.0))
            .with_clip(n(30.0), n(230.0)),
        settings: Settings::new(),
        size: [240, 240],
    };
}
