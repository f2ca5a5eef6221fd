//! The ray-traced scene of "Everybody Wants to Crank the World" (A. Pranckevičius,
//! github.com/aras-p/demo-pd-cranktheworld), in linear levels as there: a demo for the Playdate,
//! which shows it in black and white with one pixel in six traced a frame.
//!
//! Balls have one level all over and only the ground takes shadows: a quarter of its light is
//! ambient. Of the pixels, 92 % are within 3/255 of the original's. The others lie on the ground,
//! where the original's tiles change their place at the chessboard's middle lines (the board lies
//! half a tile further back here, so that most of the picture agrees), and in the mirror, where its
//! dark tiles are darker and have no shadows. The third ball, twice as far from the mirror as the
//! first, is all but outside of the picture.

super::in_every_number! {
    static OBJECTS: [Object<S>; 4] = [
        Object::new(Shape::Sphere(Sphere::new(v(0.7609, 1.0, 1.9573), n(1.0))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(0.0, 1.0, 0.0), n(1.0))), 1),
        Object::new(Shape::Sphere(Sphere::new(v(2.7371, 1.0, 3.1857), n(1.0))), 2),
        // A square 40 by 40: twenty tiles a side.
        Object::new(Shape::Cuboid(Cuboid::new(v(-20.0, 0.0, -21.0), v(20.0, 0.0, 19.0))), 3),
    ];
    static MATERIALS: [Material<S>; 4] = [
        Material::flat(gray(75.0 / 255.0)),
        Material::flat(Rgb::BLACK).with_mirror(n(225.0 / 256.0)),
        Material::flat(gray(150.0 / 255.0)),
        Material::textured(Texture::Checker(Checker::new(gray(240.0 / 255.0), gray(50.0 / 255.0), n(20.0)))),
    ];
    // The light falls at 45 degrees: times that cosine it is the three quarters that are not ambient.
    static LIGHTS: [Light<S>; 1] =
        [Light::directional(v(0.8, 1.0, 0.6), gray(0.75 * core::f64::consts::SQRT_2))];

    /// A grey and a mirroring ball on a chessboard.
    pub const VIEW: View<S> = View {
        name: "playdate",
        about: "balls on a black and white chessboard, after A. Pranckevičius's demo for the Playdate",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.25))
            .with_sky(Sky::Solid(Rgb::WHITE)),
        camera: Camera::perspective(v(3.1520, 2.3, 2.4626), v(0.0, 1.0, 0.0), v(0.0, 1.0, 0.0), n(60.0)),
        settings: Settings::new().with_depth(1).with_transfer(Transfer::Linear),
        size: [320, 240],
    };
}
