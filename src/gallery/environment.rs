//! A dusk over a lake on the six faces of a cube, seen behind three balls and in them.

super::in_every_number! {
    use crate::gallery::images::DUSK;

    static OBJECTS: [Object<S>; 3] = [
        Object::new(Shape::Sphere(Sphere::new(v(-0.45, 0.1, 0.0), n(1.0))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(1.15, -0.4, 0.7), n(0.5))), 1),
        Object::new(Shape::Sphere(Sphere::new(v(0.75, 0.75, -1.4), n(0.45))), 2),
    ];
    static MATERIALS: [Material<S>; 3] = [
        Material::matte(gray(0.02)).with_specular(rgb(0.8, 0.6, 0.4), 200).with_mirror(n(0.9)),
        Material::matte(rgb(0.55, 0.06, 0.05)).with_specular(gray(0.4), 60).with_mirror(n(0.35)),
        Material::matte(rgb(0.30, 0.19, 0.04)).with_specular(gray(0.4), 60).with_mirror(n(0.5)),
    ];
    static LIGHTS: [Light<S>; 1] = [Light::directional(v(-0.6, 0.25, -0.35), rgb(1.0, 0.75, 0.45))];

    /// Mirroring balls in the dusk.
    pub const VIEW: View<S> = View {
        name: "environment",
        about: "balls that mirror a dusk over a lake, which lies on the six faces of a cube",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(rgb(0.14, 0.13, 0.18))
            .with_sky(Sky::Cube(Cube::new(&DUSK))),
        camera: Camera::perspective(v(1.6, 0.5, 5.4), v(0.1, 0.2, 0.0), v(0.0, 1.0, 0.0), n(36.0)),
        settings: Settings::new().with_depth(3),
        size: [320, 240],
    };
}
