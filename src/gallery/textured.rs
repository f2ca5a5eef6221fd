//! An image on each shape that takes one, as the shape's coordinates lay it: a world on a ball, letters
//! on a box and on a triangle, a pavement on a plane; rings and stripes beside them.

super::in_every_number! {
    use crate::gallery::images::{LETTERS, PAVEMENT, WORLD};

    static OBJECTS: [Object<S>; 6] = [
        Object::new(Shape::Plane(Plane::new(Vec3::ZERO, v(0.0, 1.0, 0.0))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(-1.25, 1.0, -0.5), n(1.0))), 1),
        Object::new(Shape::Cuboid(Cuboid::new(v(0.5, 0.0, -1.1), v(1.7, 1.2, 0.1))), 2),
        Object::new(
            Shape::Triangle(Triangle::new(v(-0.75, 0.0, 1.5), v(0.65, 0.0, 1.7), v(-0.55, 1.1, 1.2))),
            2,
        ),
        Object::new(Shape::Cuboid(Cuboid::new(v(1.2, 0.0, 0.9), v(1.8, 0.4, 1.5))), 3),
        Object::new(Shape::Sphere(Sphere::new(v(-1.7, 0.35, 1.3), n(0.35))), 4),
    ];
    static MATERIALS: [Material<S>; 5] = [
        // The plane's v is z, which comes toward the viewer: mirrored, the pavement reads right.
        Material::textured(Texture::Image(
            Image::new(PAVEMENT).with_tiles(n(0.25), n(-0.25)).with_filter(Filter::Nearest),
        )),
        Material::textured(Texture::Image(Image::new(WORLD))).with_specular(gray(0.25), 40),
        Material::textured(Texture::Image(Image::new(LETTERS))),
        Material::textured(Texture::Rings(
            Rings::new(gray(0.9), rgb(0.8, 0.1, 0.05), [n(0.5), n(0.5)], n(7.0)),
        )),
        Material::textured(Texture::Stripes(Stripes::new(gray(0.9), rgb(0.9, 0.5, 0.0), [n(12.0), n(6.0)])))
            .with_specular(gray(0.3), 50),
    ];
    static LIGHTS: [Light<S>; 1] = [Light::point(v(-3.5, 6.0, 4.5), gray(0.95))];

    /// Images on every shape.
    pub const VIEW: View<S> = View {
        name: "textured",
        about: "a world on a ball, letters on a box and a triangle, a pavement on a plane, stripes and rings",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.2))
            .with_sky(Sky::Solid(rgb(0.35, 0.55, 0.9))),
        camera: Camera::perspective(v(0.4, 3.4, 6.4), v(0.05, 0.6, 0.0), v(0.0, 1.0, 0.0), n(36.0)),
        settings: Settings::new(),
        size: [320, 240],
    };
}
