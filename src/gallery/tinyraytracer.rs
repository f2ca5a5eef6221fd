//! The scene of `tinyraytracer` (D. Sokolov, github.com/ssloy/tinyraytracer), in linear levels as
//! there.

super::in_every_number! {
    static OBJECTS: [Object<S>; 5] = [
        Object::new(Shape::Sphere(Sphere::new(v(-3.0, 0.0, -16.0), n(2.0))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(-1.0, -1.5, -12.0), n(2.0))), 1),
        Object::new(Shape::Sphere(Sphere::new(v(1.5, -0.5, -18.0), n(3.0))), 2),
        Object::new(Shape::Sphere(Sphere::new(v(7.0, 5.0, -18.0), n(4.0))), 3),
        // A rectangle 20 by 20: ten tiles a side.
        Object::new(Shape::Cuboid(Cuboid::new(v(-10.0, -4.0, -30.0), v(10.0, -4.0, -10.0))), 4),
    ];
    // Colours are the original's times its diffuse weight.
    static MATERIALS: [Material<S>; 5] = [
        Material::matte(rgb(0.24, 0.24, 0.18)).with_specular(gray(0.3), 50).with_mirror(n(0.1)),
        Material::matte(Rgb::BLACK).with_specular(gray(0.5), 125).with_mirror(n(0.1)).with_glass(Glass::new(n(0.8), n(1.5))),
        Material::matte(rgb(0.27, 0.09, 0.09)).with_specular(gray(0.1), 10),
        Material::matte(Rgb::BLACK).with_specular(gray(10.0), 142).with_mirror(n(0.8)),
        Material::textured(Texture::Checker(Checker::new(gray(0.3), rgb(0.3, 0.2, 0.1), n(10.0)))),
    ];
    static LIGHTS: [Light<S>; 3] = [
        Light::point(v(-20.0, 20.0, 20.0), gray(1.5)),
        Light::point(v(30.0, 50.0, -25.0), gray(1.8)),
        Light::point(v(30.0, 20.0, 30.0), gray(1.7)),
    ];

    /// Four balls over a small chessboard.
    pub const VIEW: View<S> = View {
        name: "tinyraytracer",
        about: "four balls over a small chessboard, after D. Sokolov's tinyraytracer, one of glass",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS).with_sky(Sky::Gradient {
            up: v(0.0, 1.0, 0.0),
            nadir: Rgb::BLACK,
            zenith: rgb(0.2, 0.7, 1.3),
        }),
        camera: Camera::perspective(Vec3::ZERO, v(0.0, 0.0, -1.0), v(0.0, 1.0, 0.0), n(60.0)),
        settings: Settings::new().with_depth(3).with_transfer(Transfer::Linear),
        size: [320, 240],
    };
}
