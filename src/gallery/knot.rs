//! A trefoil knot before a mirror.

super::in_every_number! {
    super::super::meshes::mesh!(KNOT);

    static OBJECTS: [Object<S>; 2] = [
        Object::new(Shape::Mesh(&MESH), 0),
        Object::new(Shape::Plane(Plane::new(v(0.0, 0.0, -2.2), v(0.0, 0.0, 1.0))), 1),
    ];
    static MATERIALS: [Material<S>; 2] = [
        Material::matte(rgb(0.10, 0.45, 0.62)).with_specular(gray(0.7), 80).with_mirror(n(0.2)),
        Material::matte(rgb(0.42, 0.40, 0.38)).with_mirror(n(0.15)),
    ];
    static LIGHTS: [Light<S>; 1] = [Light::point(v(-4.0, 6.0, 9.0), gray(0.85))];

    /// The knot.
    pub const VIEW: View<S> = View {
        name: "knot",
        about: "a trefoil knot of 10240 smooth triangles in 266 KB of flash, with its shadow on a wall",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.15))
            .with_sky(Sky::Gradient { up: v(0.0, 1.0, 0.0), nadir: rgb(0.50, 0.42, 0.36), zenith: rgb(0.16, 0.20, 0.34) }),
        camera: Camera::perspective(v(2.6, 1.2, 10.5), v(0.1, 0.2, -0.4), v(0.0, 1.0, 0.0), n(40.0)),
        settings: Settings::new().with_depth(2),
        size: [240, 240],
    };
}
