//! An image on each shape that takes one: a world on a ball, letters on a box and on a triangle, and a
//! pavement of letters on a plane, each as the shape's coordinates lay it; stripes and rings beside them.

super::in_every_number! {
    use crate::gallery::images::{LETTERS, WORLD};

    static OBJECTS: [Object<S>; 5] = [
        Object::new(Shape::Plane(Plane::new(Vec3::ZERO, v(0.0, 1.0, 0.0))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(-1.35, 1.0, -0.2), n(1.0))), 1),
        Object::new(Shape::Cuboid(Cuboid::new(v(0.35, 0.0, -0.9), v(1.65, 1.3, 0.4))), 2),
        Object::new(Shape::Triangle(Triangle::new(v(-0.55, 0.0, 1.2), v(0.55, 0.0, 1.4), v(-0.2, 1.0, 1.1))), 2),
        Object::new(Shape::Cuboid(Cuboid::new(v(1.1, 0.0, 1.0), v(1.7, 0.35, 1.6))), 3),
    ];
    static MATERIALS: [Material<S>; 4] = [
        Material::textured(Texture::Image(Image::new(LETTERS).with_tiles(n(0.125), n(-0.125)))),
        Material::textured(Texture::Image(Image::new(WORLD))).with_specular(gray(0.25), 40),
        Material::textured(Texture::Image(Image::new(LETTERS))),
        Material::textured(Texture::Rings(Rings::new(gray(0.9), rgb(0.8, 0.1, 0.05), [n(0.5), n(0.5)], n(7.0)))),
    ];
    static LIGHTS: [Light<S>; 1] = [Light::point(v(-3.0, 6.0, 5.0), gray(0.95))];

    /// Images on every shape.
    pub const VIEW: View<S> = View {
        name: "textured",
        about: "a world on a ball, letters on a box, a triangle and a plane",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.2))
            .with_sky(Sky::Gradient { up: v(0.0, 1.0, 0.0), nadir: gray(0.9), zenith: rgb(0.35, 0.55, 0.9) }),
        camera: Camera::perspective(v(0.6, 1.7, 5.6), v(0.05, 1.1, 0.0), v(0.0, 1.0, 0.0), n(38.0)),
        settings: Settings::new(),
        size: [320, 240],
    };
}
