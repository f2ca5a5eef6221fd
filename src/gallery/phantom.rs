//! A head as a scanner sees it, its fat and muscle transparent over the bone.

super::in_every_number! {
    use crate::gallery::head::HEAD;

    static FLOOR: [Object<S>; 2] = [
        Object::new(Shape::Plane(Plane::new(v(0.0, -1.06, 0.0), v(0.0, 1.0, 0.0))), 0),
        Object::new(Shape::Plane(Plane::new(v(0.0, 0.0, -2.2), v(0.0, 0.0, 1.0))), 1),
    ];
    static MATERIALS: [Material<S>; 2] = [
        Material::textured(Texture::Checker(Checker::new(gray(0.3), gray(0.16), n(2.5)))),
        Material::matte(rgb(0.10, 0.16, 0.20)),
    ];
    static LIGHTS: [Light<S>; 2] = [
        Light::point(v(-3.0, 3.5, 5.0), rgb(0.95, 0.92, 0.85)),
        Light::directional(v(1.0, 0.4, 0.2), rgb(0.16, 0.18, 0.22)),
    ];
    static BODY: Volume<S> = Volume::new(
        Grid::new(HEAD, v(-0.846, -1.06, -0.98), v(0.036, 0.0365, 0.0365)),
        &Class::TISSUES,
        n(60.0),
    );

    /// A head one can look into.
    pub const VIEW: View<S> = View {
        name: "phantom",
        about: "a head as a scanner sees it: fat and muscle that light comes through, and bone",
        scene: Scene::new(&FLOOR, &MATERIALS, &LIGHTS).with_ambient(gray(0.18)).with_volume(&BODY),
        camera: Camera::perspective(v(-2.4, 0.5, 4.4), v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0), n(30.0)),
        settings: Settings::new(),
        size: [240, 240],
    };
}
