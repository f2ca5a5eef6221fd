//! A head as a scanner sees it, its fat and muscle transparent over the bone.

super::in_every_number! {
    use crate::gallery::head::HEAD;

    static OBJECTS: [Object<S>; 3] = [
        Object::new(Shape::Plane(Plane::new(v(0.0, -1.6, 0.0), v(0.0, 1.0, 0.0))), 0),
        Object::new(Shape::Plane(Plane::new(v(0.0, 0.0, -2.6), v(0.0, 0.0, 1.0))), 1),
        Object::new(Shape::Cuboid(Cuboid::new(v(-0.46, -1.6, -0.58), v(0.46, -0.98, 0.34))), 2),
    ];
    static MATERIALS: [Material<S>; 3] = [
        Material::textured(Texture::Checker(Checker::new(gray(0.32), gray(0.17), n(2.0)))),
        Material::matte(rgb(0.08, 0.14, 0.19)),
        Material::matte(rgb(0.16, 0.15, 0.15)).with_specular(gray(0.3), 30),
    ];
    static LIGHTS: [Light<S>; 2] = [
        Light::point(v(-3.0, 3.5, 5.0), rgb(0.95, 0.92, 0.85)),
        Light::directional(v(1.0, 0.4, 0.2), rgb(0.16, 0.18, 0.22)),
    ];
    static BODY: Volume<S> = Volume::new(
        Grid::new(HEAD, v(-0.846, -1.06, -0.98), v(0.036, 0.0365, 0.0365)),
        &Class::TISSUES,
        n(24.0),
    )
    .with_samples(2);

    /// A head one can look into.
    pub const VIEW: View<S> = View {
        name: "phantom",
        about: "a head as a scanner sees it: fat and muscle that light comes through, and bone",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS).with_ambient(gray(0.18)).with_volume(&BODY),
        camera: Camera::perspective(v(-2.2, 0.55, 4.3), v(0.0, -0.03, 0.0), v(0.0, 1.0, 0.0), n(26.5)),
        settings: Settings::new(),
        size: [240, 240],
    };
}
