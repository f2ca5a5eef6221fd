//! A small moon: a ball whose points a map of heights has moved, with its outline and its shadows.

super::in_every_number! {
    use crate::gallery::images::CRATERS;

    static OBJECTS: [Object<S>; 2] = [
        Object::new(Shape::Displaced(Displaced::new(
            Sphere::new(v(0.0, 0.25, 0.0), n(1.1)),
            Image::new(CRATERS),
            n(0.26),
        )), 0),
        Object::new(Shape::Plane(Plane::new(v(0.0, -1.3, 0.0), v(0.0, 1.0, 0.0))), 1),
    ];
    static MATERIALS: [Material<S>; 2] = [
        Material::matte(rgb(0.72, 0.66, 0.58)),
        Material::matte(rgb(0.16, 0.19, 0.26)),
    ];
    static LIGHTS: [Light<S>; 2] = [
        Light::directional(v(-0.8, 0.8, 0.7), rgb(1.05, 1.0, 0.9)),
        Light::directional(v(1.0, 0.1, 0.5), rgb(0.05, 0.08, 0.16)),
    ];

    /// A small moon above a floor.
    pub const VIEW: View<S> = View {
        name: "displaced",
        about: "a small moon: a ball whose points a map of craters has moved, outline and shadows included",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.06))
            .with_sky(Sky::Gradient {
                up: v(0.0, 1.0, 0.0),
                nadir: rgb(0.25, 0.28, 0.36),
                zenith: rgb(0.01, 0.01, 0.04),
            }),
        camera: Camera::perspective(v(1.5, 1.2, 5.2), v(0.1, 0.0, 0.0), v(0.0, 1.0, 0.0), n(38.0)),
        settings: Settings::new(),
        size: [240, 240],
    };
}
