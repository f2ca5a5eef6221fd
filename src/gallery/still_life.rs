//! Cones and cylinders, solid and open, on a table.

super::in_every_number! {
    use crate::gallery::images::PEEL;

    const fn cone(base: Vec3<S>, base_radius: f64, apex: Vec3<S>, apex_radius: f64) -> Cone<S> {
        Cone::new(base, n(base_radius), apex, n(apex_radius))
    }

    static OBJECTS: [Object<S>; 11] = [
        Object::new(Shape::Plane(Plane::new(v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0))), 0),
        Object::new(Shape::Plane(Plane::new(v(0.0, 0.0, -3.5), v(0.0, 0.0, 1.0))), 1),
        // A hat with a stripe wound around it.
        Object::new(Shape::Cone(cone(v(-1.7, 0.0, -1.0), 0.85, v(-1.7, 2.3, -1.0), 0.0)), 2),
        // A candle in its stand, and its flame.
        Object::new(Shape::Cone(cone(v(0.2, 0.0, -1.5), 0.75, v(0.2, 0.2, -1.5), 0.6)), 3),
        Object::new(Shape::Cone(cone(v(0.2, 0.2, -1.5), 0.25, v(0.2, 1.9, -1.5), 0.25)), 4),
        Object::new(Shape::Cone(cone(v(0.2, 1.98, -1.5), 0.1, v(0.2, 2.4, -1.5), 0.0)), 5),
        // A cup that is wider above, and a ball in it.
        Object::new(Shape::Cone(cone(v(1.75, 0.0, -0.7), 0.5, v(1.75, 1.1, -0.7), 0.85).open()), 6),
        Object::new(Shape::Sphere(Sphere::new(v(1.75, 0.75, -0.7), n(0.6))), 7),
        // A pipe of clay and one of hammered silver, and a brass weight.
        Object::new(Shape::Cone(cone(v(-0.75, 0.41, 1.15), 0.4, v(0.55, 0.41, -0.25), 0.4).open()), 8),
        Object::new(Shape::Cone(cone(v(0.2, 0.31, 1.75), 0.3, v(1.3, 0.31, 0.75), 0.3).open()), 9),
        Object::new(Shape::Cone(cone(v(-1.55, 0.16, 0.9), 0.15, v(-1.15, 0.16, 1.5), 0.15)), 3),
    ];
    static MATERIALS: [Material<S>; 10] = [
        Material::matte(rgb(0.42, 0.27, 0.17)).with_mirror(n(0.08)),
        Material::matte(rgb(0.3, 0.42, 0.45)),
        Material::textured(Texture::Stripes(Stripes::new(
            rgb(0.85, 0.8, 0.7),
            rgb(0.15, 0.2, 0.55),
            [n(2.0), n(9.0)],
        ))),
        Material::matte(rgb(0.75, 0.55, 0.2)).with_specular(rgb(0.9, 0.7, 0.3), 40).with_mirror(n(0.2)),
        Material::matte(rgb(0.9, 0.86, 0.75)).with_specular(gray(0.2), 10),
        Material::flat(rgb(1.0, 0.75, 0.25)),
        Material::matte(rgb(0.1, 0.5, 0.4)).with_specular(gray(0.6), 60),
        Material::matte(rgb(0.85, 0.2, 0.12)).with_specular(gray(0.6), 60),
        Material::matte(rgb(0.75, 0.3, 0.15)).with_specular(gray(0.3), 20),
        Material::matte(rgb(0.55, 0.57, 0.6))
            .with_specular(gray(0.7), 50)
            .with_mirror(n(0.25))
            .with_bump(Bump::heights(Image::new(PEEL).with_tiles(n(3.0), n(2.0)), n(0.012))),
    ];
    static LIGHTS: [Light<S>; 2] = [
        Light::point(v(-4.0, 6.0, 4.0), rgb(0.8, 0.75, 0.65)),
        Light::point(v(5.0, 4.0, 5.0), rgb(0.2, 0.22, 0.28)),
    ];

    /// A hat, a candle, a cup and pipes.
    pub const VIEW: View<S> = View {
        name: "still-life",
        about: "cones and cylinders on a table: a hat and a candle closed by caps, a cup and pipes open at both ends; \
            stripes and bumps follow what they are wound around",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS).with_ambient(gray(0.15)),
        camera: Camera::perspective(v(-0.4, 3.3, 6.2), v(0.0, 0.8, -0.5), v(0.0, 1.0, 0.0), n(38.0)),
        settings: Settings::new().with_depth(2),
        size: [320, 240],
    };
}
