//! Steps, a pyramid and a ball in an isometric drawing: parallel rays, light from infinity.

super::in_every_number! {
    static OBJECTS: [Object<S>; 9] = [
        Object::new(Shape::Cuboid(Cuboid::new(v(-3.0, -0.2, -3.0), v(3.0, 0.0, 3.0))), 0),
        Object::new(Shape::Cuboid(Cuboid::new(v(-2.5, 0.0, -2.5), v(-0.5, 0.5, 0.5))), 1),
        Object::new(Shape::Cuboid(Cuboid::new(v(-2.5, 0.5, -2.5), v(-0.5, 1.0, -0.5))), 1),
        Object::new(Shape::Cuboid(Cuboid::new(v(-2.5, 1.0, -2.5), v(-0.5, 1.5, -1.5))), 1),
        Object::new(Shape::Triangle(Triangle::new(v(0.5, 0.0, 2.5), v(2.5, 0.0, 2.5), v(1.5, 1.8, 1.5))), 2),
        Object::new(Shape::Triangle(Triangle::new(v(2.5, 0.0, 2.5), v(2.5, 0.0, 0.5), v(1.5, 1.8, 1.5))), 2),
        Object::new(Shape::Triangle(Triangle::new(v(2.5, 0.0, 0.5), v(0.5, 0.0, 0.5), v(1.5, 1.8, 1.5))), 2),
        Object::new(Shape::Triangle(Triangle::new(v(0.5, 0.0, 0.5), v(0.5, 0.0, 2.5), v(1.5, 1.8, 1.5))), 2),
        Object::new(Shape::Sphere(Sphere::new(v(1.4, 0.8, -1.4), n(0.8))), 3),
    ];
    static MATERIALS: [Material<S>; 4] = [
        Material::textured(Texture::Checker(Checker::new(gray(0.7), gray(0.5), n(6.0)))),
        Material::matte(rgb(0.8, 0.5, 0.2)),
        Material::matte(rgb(0.2, 0.6, 0.5)),
        Material::matte(rgb(0.7, 0.15, 0.3)).with_specular(gray(0.5), 40),
    ];
    static LIGHTS: [Light<S>; 1] = [Light::directional(v(0.35, 1.0, 0.75), gray(0.85))];

    /// An isometric drawing.
    pub const VIEW: View<S> = View {
        name: "orthographic",
        about: "steps, a pyramid of triangles and a ball under parallel rays and a distant light",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.25))
            .with_sky(Sky::Solid(rgb(0.75, 0.82, 0.9))),
        camera: Camera::orthographic(v(10.0, 8.5, 10.0), v(0.0, 0.3, 0.0), v(0.0, 1.0, 0.0), n(7.0)),
        settings: Settings::new(),
        size: [320, 240],
    };
}
