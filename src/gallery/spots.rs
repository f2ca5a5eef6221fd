//! Three coloured spots on a white stage: their cones add up to white where all three meet.

super::in_every_number! {
    static OBJECTS: [Object<S>; 2] = [
        Object::new(Shape::Plane(Plane::new(Vec3::ZERO, v(0.0, 1.0, 0.0))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(0.0, 0.8, 0.0), n(0.8))), 1),
    ];
    static MATERIALS: [Material<S>; 2] = [
        Material::matte(gray(0.85)),
        Material::matte(gray(0.85)).with_specular(gray(0.35), 60).with_model(Model::BlinnPhong),
    ];

    /// Makes a lamp on a ring above the stage that shines beyond the middle.
    const fn lamp(x: f64, z: f64, color: Rgb<S>) -> Light<S> {
        let axis = v(-0.72 * x, -6.0, -0.72 * z);
        Light::spot(v(x, 6.0, z), axis, n(cosine(19.0)), 12, color)
    }
    static LIGHTS: [Light<S>; 3] = [
        lamp(0.0, 4.0, rgb(1.0, 0.05, 0.05)),
        lamp(-3.46, -2.0, rgb(0.05, 1.0, 0.05)),
        lamp(3.46, -2.0, rgb(0.05, 0.1, 1.0)),
    ];

    /// A white ball in red, green and blue light.
    pub const VIEW: View<S> = View {
        name: "spots",
        about: "a white ball on a white stage in the cones of a red, a green and a blue spot",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS).with_ambient(gray(0.03)),
        camera: Camera::perspective(v(0.0, 5.6, 8.2), v(0.0, 0.3, 0.1), v(0.0, 1.0, 0.0), n(38.0)),
        settings: Settings::new(),
        size: [320, 240],
    };
}
