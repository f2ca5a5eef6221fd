//! Things that no order of drawing gets right, only depths pixel by pixel: three beams each of which lies
//! before the next, a ball in a slab, triangles through each other.

super::in_every_number! {
    static OBJECTS: [Object<S>; 9] = [
        Object::new(Shape::Plane(Plane::new(Vec3::ZERO, v(0.0, 1.0, 0.0))), 0),
        // Seen from (1, 1, 1) each beam passes before the next one, and the last before the first.
        Object::new(Shape::Cuboid(Cuboid::new(v(-2.3, 1.1, 0.2), v(1.9, 1.7, 0.8))), 1),
        Object::new(Shape::Cuboid(Cuboid::new(v(0.2, 0.0, -0.8), v(0.8, 3.8, -0.2))), 2),
        Object::new(Shape::Cuboid(Cuboid::new(v(-0.8, 2.1, -1.9), v(-0.2, 2.7, 2.3))), 3),
        Object::new(Shape::Cuboid(Cuboid::new(v(2.2, 0.0, -1.7), v(4.0, 0.3, 0.1))), 4),
        Object::new(Shape::Sphere(Sphere::new(v(3.1, 0.55, -0.8), n(0.7))), 5),
        Object::new(Shape::Triangle(Triangle::new(v(-0.7, 0.0, 3.4), v(1.1, 0.0, 3.4), v(0.2, 2.0, 3.4))), 6),
        Object::new(Shape::Triangle(Triangle::new(v(-0.25, 0.0, 2.62), v(0.65, 0.0, 4.18), v(0.2, 2.0, 3.4))), 7),
        Object::new(Shape::Triangle(Triangle::new(v(-0.25, 0.0, 4.18), v(0.65, 0.0, 2.62), v(0.2, 2.0, 3.4))), 6),
    ];
    static MATERIALS: [Material<S>; 8] = [
        Material::textured(Texture::Checker(Checker::new(rgb(0.6, 0.58, 0.54), rgb(0.48, 0.46, 0.43), n(0.5)))),
        Material::matte(rgb(0.85, 0.16, 0.1)).with_specular(gray(0.2), 30),
        Material::matte(rgb(0.08, 0.55, 0.32)).with_specular(gray(0.2), 30),
        Material::matte(rgb(0.1, 0.28, 0.8)).with_specular(gray(0.2), 30),
        Material::textured(Texture::Checker(Checker::new(gray(0.85), rgb(0.3, 0.2, 0.16), n(4.0)))),
        Material::matte(rgb(0.95, 0.6, 0.08)).with_specular(gray(0.6), 60),
        Material::textured(Texture::Checker(Checker::new(rgb(0.85, 0.35, 0.55), rgb(0.6, 0.12, 0.35), n(6.0)))),
        Material::textured(Texture::Checker(Checker::new(rgb(0.45, 0.75, 0.9), rgb(0.12, 0.4, 0.6), n(6.0)))),
    ];
    static LIGHTS: [Light<S>; 2] = [
        Light::directional(v(0.55, 1.0, 0.2), gray(0.8)),
        Light::point(v(-4.0, 5.0, 9.0), rgb(0.25, 0.28, 0.36)),
    ];

    /// Beams that lie before each other in a ring, and things that stick in each other.
    pub const VIEW: View<S> = View {
        name: "z-buffer",
        about: "beams each before the next, a ball in a slab, triangles through each other: what depths get right and no order of drawing does",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.22))
            .with_sky(Sky::Solid(rgb(0.5, 0.6, 0.7))),
        camera: Camera::perspective(v(7.4, 7.4, 7.4), v(0.7, 1.2, 0.5), v(0.0, 1.0, 0.0), n(31.0)),
        settings: Settings::new(),
        size: [320, 240],
    };
}
