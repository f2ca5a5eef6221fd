//! The Utah teapot, on a table.

super::in_every_number! {
    super::super::meshes::mesh!(TEAPOT);

    static OBJECTS: [Object<S>; 2] = [
        Object::new(Shape::Mesh(&MESH), 0),
        Object::new(Shape::Plane(Plane::new(v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0))), 1),
    ];
    static MATERIALS: [Material<S>; 2] = [
        Material::matte(rgb(0.80, 0.42, 0.16)).with_specular(gray(0.6), 60).with_mirror(n(0.12)),
        Material::textured(Texture::Checker(Checker::new(gray(0.55), rgb(0.30, 0.34, 0.42), n(0.5)))).with_mirror(n(0.08)),
    ];
    static LIGHTS: [Light<S>; 2] = [
        Light::point(v(-5.0, 9.0, 6.0), gray(0.75)),
        Light::point(v(7.0, 5.0, 3.0), rgb(0.20, 0.22, 0.28)),
    ];

    /// The teapot.
    pub const VIEW: View<S> = View {
        name: "teapot",
        about: "the Utah teapot in 992 smooth triangles, found in flash by a tree of boxes",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.14))
            .with_sky(Sky::Gradient { up: v(0.0, 1.0, 0.0), nadir: rgb(0.55, 0.60, 0.68), zenith: rgb(0.10, 0.16, 0.32) }),
        camera: Camera::perspective(v(2.2, 4.6, 8.6), v(0.25, 1.25, 0.0), v(0.0, 1.0, 0.0), n(34.0)),
        settings: Settings::new().with_depth(2),
        size: [320, 240],
    };
}
